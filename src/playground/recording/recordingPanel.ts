import { append, appendButton } from '../panels/elements';
import type { Replay, StepUnit } from './replay';

export interface RecordingListeners {
  readonly replay: () => void;
  readonly leave: () => void;
  readonly save: () => void;
  readonly load: (file: File) => void;
  readonly seek: (at: number) => void;
  readonly play: (playing: boolean) => void;
  readonly step: (unit: StepUnit, direction: 1 | -1) => void;
}

export interface RecordingPanel {
  readonly showLength: (seconds: number, hasDropped: boolean) => void;
  readonly showReplay: (replay: Replay | null) => void;
  /** `where`: tick and substep in words. */
  readonly showPosition: (at: number, playing: boolean, where: string) => void;
  readonly showProgress: (share: number | null) => void;
}

const STEPS = [
  ['◂ Tick', 'One tick back', 'tick', -1],
  ['◂ Substep', 'One substep back', 'substep', -1],
  ['Substep ▸', 'One substep forward', 'substep', 1],
  ['Tick ▸', 'One tick forward', 'tick', 1],
] as const;

/** Record, replay, save and load; the scrubber goes both ways and marks the first divergence. */
export function createRecordingPanel(host: Element, listeners: RecordingListeners): RecordingPanel {
  const row = append(host, 'div', 'row');
  const length = append(row, 'span', 'quiet');
  const replayButton = appendButton(row, 'Replay', listeners.replay);
  const save = appendButton(row, 'Save', listeners.save);
  appendFileField(row, listeners);
  const progress = append(row, 'progress');
  progress.max = 1;
  progress.hidden = true;
  progress.setAttribute('aria-label', 'Writing the recording');
  const deck = appendDeck(host, listeners);
  let shownSeconds = NaN;
  return {
    showLength(seconds, hasDropped) {
      const whole = Math.round(seconds);
      if (whole === shownSeconds) return;
      shownSeconds = whole;
      length.textContent = `Recorded ${hasDropped ? 'the last ' : ''}${String(whole)} s`;
    },
    showReplay(replay) {
      replayButton.disabled = replay !== null;
      save.disabled = replay !== null;
      deck.showReplay(replay);
    },
    showPosition: deck.showPosition,
    showProgress(share) {
      progress.hidden = share === null;
      progress.value = share ?? 0;
    },
  };
}

function appendFileField(row: Element, { load }: RecordingListeners): void {
  const label = append(row, 'label', 'row');
  append(label, 'span', '', 'Load');
  const file = append(label, 'input');
  file.type = 'file';
  file.accept = '.jsonl,application/jsonl';
  file.addEventListener('change', () => {
    const chosen = file.files?.[0];
    if (chosen !== undefined) load(chosen);
    file.value = '';
  });
}

/** The controls of a replay: hidden without one. */
function appendDeck(
  host: Element,
  listeners: RecordingListeners,
): Pick<RecordingPanel, 'showReplay' | 'showPosition'> {
  const deck = append(host, 'div');
  deck.hidden = true;
  const controls = append(deck, 'div', 'row');
  let isPlaying = true;
  const play = appendButton(controls, 'Pause', () => listeners.play(!isPlaying));
  for (const [text, label, unit, direction] of STEPS)
    appendButton(controls, text, () => listeners.step(unit, direction)).setAttribute('aria-label', label);
  const scrubber = append(controls, 'div', 'scrubber');
  const range = append(scrubber, 'input');
  range.type = 'range';
  range.step = '0.01';
  range.setAttribute('aria-label', 'Time in the recording, seconds');
  range.addEventListener('input', () => listeners.seek(from + range.valueAsNumber));
  const mark = append(scrubber, 'span', 'mark');
  const time = append(controls, 'span', 'quiet');
  appendButton(controls, 'Back to the game', listeners.leave);
  const words = append(deck, 'p', 'quiet');
  words.setAttribute('role', 'status');
  let from = 0;
  let long = 1;
  return {
    showReplay(replay) {
      deck.hidden = replay === null;
      if (replay === null) return;
      from = replay.from;
      long = Math.max(replay.to - replay.from, 1e-3);
      range.max = long.toFixed(2);
      words.textContent = replay.divergence.words;
      mark.hidden = replay.divergence.at === null;
      // The middle of the slider's thumb moves from 8 px after its start to 8 px before its end.
      const share = ((replay.divergence.at ?? from) - from) / long;
      mark.style.setProperty('left', `calc(8px + ${share} * (100% - 16px))`);
    },
    showPosition(at, playing, where) {
      isPlaying = playing;
      const text = playing ? 'Pause' : 'Play';
      if (play.textContent !== text) play.textContent = text;
      range.value = (at - from).toFixed(2);
      time.textContent = `${(at - from).toFixed(2)} / ${long.toFixed(1)} s · ${where}`;
    },
  };
}
