import type { EventNotice } from '../../../src/index';
import type { Run } from './run';
import { type DrawnError, errorOf, type Sample } from './watch';

/** s: a stall of the network is bridged this long, or for three sends. */
const HORIZON = 5;
/** s off that are still right, the grain of the page's clock aside. */
const RIGHT = 0.05;
/** m: what is landed and confirmed is there. */
const LANDED_WITHIN = 0.1;
/** m: the same for one that coasts; a position of 1e11 m has an ulp of 15 µm. */
const COASTING_WITHIN = 0.5;
/** m by which the drawn ship may be in the ground where both grounds are the same. */
const UNDER = 0.05;
/** s for which CONTACT is shown at least. */
const DWELL = 0.3;
/** s: what is pressed shorter than a display frame or two is not seen. */
const KEY_WITHIN = 0.05;

/** What did not hold in a run; empty where all did. Each line begins with the number that broke. */
export function breaksOf(run: Run): string[] {
  return [
    ...run.watch.faults,
    ...ofTime(run),
    ...ofPlace(run),
    ...ofStatus(run),
    ...ofEvents(run.page.notices),
    ...ofKeys(run),
  ];
}

/** s after the fault from which on all must be right: 1 s or two sends; without pongs three frames tell that the schedule moved. */
function allowed({ send, page }: Run): number {
  const { answersPings, network } = page.setup;
  return Math.max(1, (answersPings ? 2 : 3) * send) + 2 * network.delay;
}

function* ofTime(run: Run): Generator<string> {
  const { watch, send, over, page } = run;
  const { grain } = page.setup;
  const ahead = worst(watch.samples, ({ ahead }) => ahead);
  const horizon = Math.max(HORIZON, 3 * send) + RIGHT + grain;
  if (ahead.value > horizon)
    yield `${ahead.value.toFixed(2)} s drawn beyond the newest frame, at most ${horizon.toFixed(2)}, at ${ahead.at} s`;
  const usual = watch.samples.filter(({ t }) => t > run.from / 2 && t < run.from).map((s) => s.drawn - s.t);
  const [least, most] = [Math.min(...usual), Math.max(...usual)];
  const after = watch.samples.filter(({ t }) => t > over + allowed(run));
  const off = worst(after, (s) => Math.max(s.drawn - s.t - most, least - (s.drawn - s.t)));
  if (off.value > RIGHT + grain)
    yield `${off.value.toFixed(3)} s off the instant that was drawn before the fault, ${(Number(off.at) - over).toFixed(2)} s after it`;
  if (after.length === 0 && page.ownShip !== null && page.setup.server.ships.has(page.ownShip))
    yield `0 frames have the player’s ship, from ${allowed(run)} s after the fault on`;
  const confirmed = worst(
    watch.samples.filter(({ provenance }) => provenance === 'confirmed'),
    ({ beyond }) => beyond,
  );
  if (confirmed.value > 2 * RIGHT + grain)
    yield `${confirmed.value.toFixed(2)} s beyond newest frame, interval and lead, and called confirmed, at ${confirmed.at} s`;
}

/** Samples of which the truth is known, once all is right again, and before the fault. */
function* settled(run: Run): Generator<{ readonly sample: Sample; readonly error: DrawnError }> {
  const { from, over, send, watch } = run;
  for (const sample of watch.samples) {
    const isBefore = sample.t > 3 * send + 1 && Math.max(sample.t, sample.drawn) < from;
    if (!isBefore && sample.t < over + allowed(run) + send) continue;
    const error = errorOf(sample);
    if (error !== null) yield { sample, error };
  }
}

function* ofPlace(run: Run): Generator<string> {
  const { watch, page, send } = run;
  const { rise } = page.setup;
  const clear = worst(watch.samples, (s) => -s.clear);
  const lower = Math.max(0, -rise.offset) + Math.abs(rise.slope) * MAX_WAY;
  if (clear.value > lower + UNDER)
    yield `${clear.value.toFixed(2)} m underground, with a ground known to ${lower.toFixed(2)} m, at ${clear.at} s`;
  let pressed = 0;
  const worstOf = { landed: 0, coasting: 0 };
  for (const { sample, error } of settled(run)) {
    while ((page.presses[pressed]?.at ?? Number.POSITIVE_INFINITY) <= sample.t) pressed += 1;
    const idle = sample.t - (page.presses[pressed - 1]?.at ?? 0);
    if (sample.provenance !== 'confirmed' || error.isWrong || idle < 2 * send + 1) continue;
    if (sample.shown === 'landed') worstOf.landed = Math.max(worstOf.landed, error.metres);
    else if (sample.shown === '' && !touchedNear(run, sample))
      worstOf.coasting = Math.max(worstOf.coasting, error.metres);
  }
  if (worstOf.landed > LANDED_WITHIN) yield `${worstOf.landed.toFixed(2)} m off while landed and confirmed`;
  if (worstOf.coasting > COASTING_WITHIN)
    yield `${worstOf.coasting.toFixed(2)} m off while it coasts and is confirmed`;
}

/** m a ship moves along a slope in a run, at most. */
const MAX_WAY = 300;

/** Whether the ship was on the ground within two sends before: a bounce of another law is another flight. */
function touchedNear({ watch, send }: Run, { t }: Sample): boolean {
  return watch.samples.some((s) => s.t <= t && s.t > t - 2 * send - 1 && (errorOf(s)?.state ?? '') !== '');
}

function* ofStatus(run: Run): Generator<string> {
  const { send, page } = run;
  const { delay } = page.setup.network;
  const most = DWELL + Math.max(1, send) + 2 * delay;
  let began = Number.NaN;
  let longest = { seconds: 0, at: 0, shown: '', is: '' };
  for (const { sample, error } of settled(run)) {
    if (!error.isWrong) began = Number.NaN;
    else if (Number.isNaN(began)) began = sample.t;
    const seconds = sample.t - began;
    if (seconds > longest.seconds) longest = { seconds, at: sample.t, shown: sample.shown, is: error.state };
  }
  if (longest.seconds > most)
    yield `${longest.seconds.toFixed(2)} s the status '${longest.shown}' while the server has '${longest.is}', at most ${most.toFixed(2)}, until ${longest.at.toFixed(2)} s`;
}

/** Each event ends at most once, and no more are predicted than end, but for those still open. */
function* ofEvents(notices: readonly EventNotice[]): Generator<string> {
  const ends = new Map<string, number>();
  const open = new Map<string, number>();
  for (const { kind, shipId, type, tick, substep } of notices) {
    const name = `${type} of ${shipId}`;
    open.set(name, (open.get(name) ?? 0) + (kind === 'predicted' ? 1 : -1));
    const key = `${name} ${kind} at ${tick}/${substep}`;
    if (kind !== 'predicted') ends.set(key, (ends.get(key) ?? 0) + 1);
  }
  for (const [key, count] of ends) if (count > 1) yield `${count} times ${key}`;
  for (const [name, count] of open)
    if (count > MAX_OPEN) yield `${count} of ${name} predicted and never ended`;
}

/** Touches of a ship that hops at the end of a run. */
const MAX_OPEN = 12;

/** A key acts at the next tick that it can still reach; while nothing is wrong. */
function* ofKeys(run: Run): Generator<string> {
  const { page, send, from } = run;
  const most = 1 / page.setup.server.options.tickRate + KEY_WITHIN + page.setup.grain;
  // The send interval is known from the second frame on.
  const early = page.presses.filter(({ at }) => at > 3 * send && at > 3 && at < from - 1);
  for (const [i, { at, drawnAt }] of early.entries()) {
    const held = (early[i + 1]?.at ?? Number.POSITIVE_INFINITY) - at;
    const delay = Number.isNaN(drawnAt) ? held : drawnAt - at;
    if (delay > most)
      yield `${delay.toFixed(2)} s from key to picture, at most ${most.toFixed(2)}, at ${at.toFixed(2)} s`;
  }
}

function worst(
  samples: readonly Sample[],
  value: (sample: Sample) => number,
): { readonly value: number; readonly at: string } {
  let most = { value: Number.NEGATIVE_INFINITY, at: '' };
  for (const sample of samples) {
    const found = value(sample);
    if (found > most.value) most = { value: found, at: sample.t.toFixed(2) };
  }
  return most;
}
