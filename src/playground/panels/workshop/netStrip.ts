import type { Diagnosis } from '../../../prediction';
import { append } from '../elements';

/** Kinds of frames: counter in the diagnosis, word, colour and height of the mark (so that colour is not the only sign). */
const OUTCOMES = [
  { counter: 'framesAccepted', word: 'accepted', colour: '#58b8ff', height: 0.55 },
  { counter: 'framesDuplicate', word: 'duplicate', colour: '#b3c0cd', height: 0.3 },
  { counter: 'framesOutOfOrder', word: 'out of order', colour: '#ffd24a', height: 0.8 },
  { counter: 'framesTooOld', word: 'too old', colour: '#c88cff', height: 0.9 },
  { counter: 'framesFromFuture', word: 'from the future', colour: '#7dff9a', height: 0.9 },
  { counter: 'framesRefused', word: 'refused', colour: '#ff6a5e', height: 1 },
] as const satisfies readonly { counter: keyof Diagnosis; word: string; colour: string; height: number }[];

const CORRECTIONS = [
  ['correctionsLateInput', 'late input'],
  ['correctionsLostInput', 'lost input'],
  ['correctionsOtherPilot', 'other pilot'],
  ['correctionsMismatch', 'mismatch'],
] as const satisfies readonly (readonly [keyof Diagnosis, string])[];

/** Seconds across the strip. */
const SPAN = 20;
/** Most new marks of one kind per update: after a long absence the counters have grown by thousands. */
const MAX_MARKS = 50;

interface Mark {
  readonly at: number;
  /** Index into OUTCOMES. */
  readonly outcome: number;
}

/** The network of the last seconds: one mark per frame, by its kind, the newest at the right; counts in words below. */
export interface NetStrip {
  /** Reads the counters' changes since the last call. */
  readonly watch: (diagnosis: Diagnosis, now: number) => void;
  readonly paint: (diagnosis: Diagnosis, now: number) => void;
  readonly clear: () => void;
}

export function createNetStrip(host: Element): NetStrip {
  const row = append(host, 'div', 'strip');
  append(row, 'span', '', 'Frames');
  const canvas = append(row, 'canvas');
  canvas.setAttribute('aria-hidden', 'true');
  const legend = append(host, 'div', 'legend');
  const counts = append(legend, 'span');
  const corrections = append(legend, 'span');
  const context = canvas.getContext('2d');
  // The size is observed: a query within a frame would force a layout.
  new ResizeObserver(() => {
    canvas.width = canvas.clientWidth;
    canvas.height = canvas.clientHeight;
  }).observe(canvas);
  const before: number[] = OUTCOMES.map(() => 0);
  let marks: Mark[] = [];

  return {
    watch(diagnosis, now) {
      OUTCOMES.forEach(({ counter }, outcome) => {
        const count = diagnosis[counter];
        const come = Math.min(count - before[outcome]!, MAX_MARKS);
        for (let i = 0; i < come; i++) marks.push({ at: now, outcome });
        before[outcome] = count;
      });
    },
    paint(diagnosis, now) {
      marks = marks.filter(({ at }) => at > now - SPAN && at <= now);
      if (context !== null) drawMarks(context, canvas, marks, now);
      const counted = OUTCOMES.filter(({ counter }, i) => i === 0 || diagnosis[counter] > 0);
      showText(counts, counted.map(({ counter, word }) => `${diagnosis[counter]} ${word}`).join(' · '));
      const made = CORRECTIONS.filter(([counter]) => diagnosis[counter] > 0);
      const words = made.map(([counter, word]) => `${diagnosis[counter]} ${word}`).join(', ');
      const mismatch = diagnosis.lastMismatch === '' ? '' : ` (${diagnosis.lastMismatch})`;
      showText(corrections, `Corrections: ${words === '' ? 'none' : words}${mismatch}`);
    },
    clear() {
      marks = [];
      before.fill(0);
    },
  };
}

function drawMarks(
  context: CanvasRenderingContext2D,
  canvas: HTMLCanvasElement,
  marks: readonly Mark[],
  now: number,
): void {
  const { width, height } = canvas;
  context.clearRect(0, 0, width, height);
  context.fillStyle = 'rgba(128,144,160,0.35)';
  context.fillRect(0, height - 1, width, 1);
  for (const { at, outcome } of marks) {
    const { colour, height: share } = OUTCOMES[outcome]!;
    context.fillStyle = colour;
    context.fillRect(width * (1 - (now - at) / SPAN) - 3, height * (1 - share), 3, height * share);
  }
}

function showText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
