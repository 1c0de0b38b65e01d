/** The members used of an event of the browser's trace. Times in µs; `tdur` is the thread's CPU time. */
export interface TraceEvent {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  readonly dur?: number;
  readonly tdur?: number;
  readonly args?: { readonly name?: string };
}

/** Cost of a frame, ms: wall time, and the thread's CPU time, without waiting. */
export interface FrameFigure {
  readonly name: string;
  readonly unit: 'ms';
  readonly frames: number;
  readonly p50: number;
  readonly p95: number;
  readonly max: number;
}

/** All trace events in which a page's thread runs script. */
const SCRIPT = new Set([
  'FireAnimationFrame',
  'FunctionCall',
  'TimerFire',
  'EvaluateScript',
  'HandlePostMessage',
]);

/** Script time of each frame: of its callback, and of everything since the last frame. */
export function frameFigures(name: string, events: readonly TraceEvent[]): FrameFigure[] {
  const thread = busiestThread(events);
  const script = events
    .filter(({ ph, pid, tid }) => ph === 'X' && `${pid}:${tid}` === thread)
    .filter(({ name: what }) => SCRIPT.has(what))
    .sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  const wall: number[] = [];
  const ran: number[] = [];
  let end = -Infinity;
  let sum = { wall: 0, ran: 0 };
  for (const event of script) {
    // Nested events are counted with the outer one.
    if (event.ts < end) continue;
    end = event.ts + (event.dur ?? 0);
    sum = { wall: sum.wall + (event.dur ?? 0), ran: sum.ran + (event.tdur ?? 0) };
    if (event.name !== 'FireAnimationFrame') continue;
    wall.push(sum.wall / 1000);
    ran.push(sum.ran / 1000);
    sum = { wall: 0, ran: 0 };
  }
  if (wall.length < 2) throw new Error(`${name}: the trace holds ${wall.length} frames`);
  // The first frame includes what ran when the trace began.
  return [figureOf(`${name}-script`, ran.slice(1)), figureOf(`${name}-script-wall`, wall.slice(1))];
}

/** The thread that draws the frames: process and thread. */
function busiestThread(events: readonly TraceEvent[]): string {
  const counts = new Map<string, number>();
  for (const { name, pid, tid } of events)
    if (name === 'FireAnimationFrame') counts.set(`${pid}:${tid}`, (counts.get(`${pid}:${tid}`) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a)[0]?.[0] ?? '';
}

export function figureOf(name: string, times: readonly number[]): FrameFigure {
  const sorted = [...times].sort((a, b) => a - b);
  const at = (share: number) => Math.round(sorted[Math.ceil(share * sorted.length) - 1]! * 100) / 100;
  return { name, unit: 'ms', frames: sorted.length, p50: at(0.5), p95: at(0.95), max: at(1) };
}
