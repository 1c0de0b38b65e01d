/** An event of the browser's trace, as far as it is read here. Times in µs; `tdur` is the time the thread itself ran. */
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

/** What a frame costs, ms: of the wall, and of the thread's own running, which leaves out waiting for others. */
export interface FrameFigure {
  readonly name: string;
  readonly unit: 'ms';
  readonly frames: number;
  readonly p50: number;
  readonly p95: number;
  readonly max: number;
}

/** Everything by which a page's thread comes to run script. */
const SCRIPT = new Set([
  'FireAnimationFrame',
  'FunctionCall',
  'TimerFire',
  'EvaluateScript',
  'HandlePostMessage',
]);

/** Script time of each frame: of its callback, and of all that ran between it and the frame before. */
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
    // What runs inside another one is counted with it.
    if (event.ts < end) continue;
    end = event.ts + (event.dur ?? 0);
    sum = { wall: sum.wall + (event.dur ?? 0), ran: sum.ran + (event.tdur ?? 0) };
    if (event.name !== 'FireAnimationFrame') continue;
    wall.push(sum.wall / 1000);
    ran.push(sum.ran / 1000);
    sum = { wall: 0, ran: 0 };
  }
  if (wall.length < 2) throw new Error(`${name}: the trace holds ${wall.length} frames`);
  // Before the first frame stands what was going on when the trace began.
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
