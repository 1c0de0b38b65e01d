import { createWindow, leastOf, restart, sample, spreadOf, type Window } from './delayWindow';

/**
 * The server's clock as the client knows it, and the present that is drawn (PREDICTION, The timeline). Wall seconds throughout:
 * `now` is the client's, handed in; server time counts from the timeline's origin.
 *
 * Each pong gives two samples, each frame one: client − server time at an arrival here (offset + delay down), and server − client
 * time at an arrival there (delay up − offset). The least of each over 10 s is the least delayed one, so half their difference
 * is the offset, but for half the difference of the two least delays; and with the lead added, that half cancels: what matters is
 * when our inputs arrive.
 */
export interface Clock {
  readonly down: Window;
  readonly up: Window;
  readonly roundTrips: Window;
  /** Client − server time, s; NaN before the first sample. */
  offset: number;
  /** Added to the lead because inputs came late, s. */
  steer: number;
  /** Server time that is drawn: estimate + lead, slewed. NaN before the first sample. */
  present: number;
  /** 0.9 … 1.1: at which the present follows its target. */
  rate: number;
  slewing: boolean;
  updatedAt: number;
  /** Latest round trip, s, smoothed. */
  roundTrip: number;
}

/** Without a pong, half of this is taken for the way down, s. */
const ASSUMED_ROUND_TRIP = 0.1;
/** Kept between an input's arrival and its need, beside the jitter, s. */
export const SLACK = 0.01;
/** An error beyond this is not slewed away but jumped, s (PREDICTION: hard reset beyond 2 s). */
export const HARD_RESET = 2;
/** s */
const IMPOSSIBLY_EARLY = 0.1;
/** The present runs at most this much faster or slower than the wall. */
const MAX_SLEW = 0.1;
/** The rate's correction is the error over this time, s, so that a small error is not chased at full slew. */
const SLEW_TIME = 0.5;
/** A slew that has begun goes on until this little is left, s. */
const SLEWED = 0.001;
/** More lead than this is not asked for, whatever the margins say, s. */
const MAX_STEER = 1;
/** The steered lead is given back at this rate, s/s. */
const STEER_DECAY = 0.004;

export function createClock(): Clock {
  return {
    down: createWindow(),
    up: createWindow(),
    roundTrips: createWindow(),
    offset: Number.NaN,
    steer: 0,
    present: Number.NaN,
    rate: 1,
    slewing: false,
    updatedAt: Number.NaN,
    roundTrip: Number.NaN,
  };
}

/** Something the server sent at server time `sentAt` arrived. */
export function sampleDown(clock: Clock, sentAt: number, now: number): void {
  const delay = now - sentAt;
  const least = leastOf(clock.down, now);
  sample(clock.down, now, delay);
  // Nothing arrives that much before the fastest: the server's schedule jumped ahead. Or it stood still, or the link did, for
  // longer than any slew may make up. Either way what came before says nothing any more.
  if (delay < least - IMPOSSIBLY_EARLY || delay > least + HARD_RESET) forget(clock, now);
  settleOffset(clock, now);
}

/** A ping of `pingedAt` was answered at server time `answeredAt` and the pong arrived; null: answered at a time that says nothing. */
export function samplePong(clock: Clock, pingedAt: number, answeredAt: number | null, now: number): void {
  const roundTrip = now - pingedAt;
  if (!(roundTrip >= 0)) return;
  sample(clock.roundTrips, now, roundTrip);
  clock.roundTrip = Number.isNaN(clock.roundTrip) ? roundTrip : clock.roundTrip * 0.8 + roundTrip * 0.2;
  if (answeredAt === null) return;
  sample(clock.up, now, answeredAt - pingedAt);
  sampleDown(clock, answeredAt, now);
}

function settleOffset(clock: Clock, now: number): void {
  const least = leastOf(clock.down, now);
  const up = leastOf(clock.up, now);
  clock.offset = Number.isNaN(up) ? least - ASSUMED_ROUND_TRIP / 2 : (least - up) / 2;
}

/** Keeps only the newest sample of the way down; the ways' lengths are kept by what the round trips say. */
function forget(clock: Clock, now: number): void {
  const oneWay = leastRoundTrip(clock, now) / 2;
  const latest = clock.down.latest;
  restart(clock.down);
  restart(clock.up);
  sample(clock.down, now, latest);
  sample(clock.up, now, 2 * oneWay - latest);
}

function leastRoundTrip(clock: Clock, now: number): number {
  const least = leastOf(clock.roundTrips, now);
  return Number.isNaN(least) ? ASSUMED_ROUND_TRIP : least;
}

/** The server's schedule is another one: only the round trips still say something. */
export function forgetSchedule(clock: Clock): void {
  restart(clock.down);
  restart(clock.up);
  clock.offset = Number.NaN;
  clock.present = Number.NaN;
}

/** Server time at which something that arrives now was sent, as estimated. */
export function sentAt(clock: Clock, now: number): number {
  return serverTime(clock, now) - leastRoundTrip(clock, now) / 2;
}

/** Server time now, as estimated; NaN before the first sample. */
export function serverTime(clock: Clock, now: number): number {
  return now - clock.offset;
}

/** How far the present should run ahead of the server so that inputs arrive in time: half the round trip + jitter + slack, steered. */
export function leadOf(clock: Clock, now: number): number {
  return leastRoundTrip(clock, now) / 2 + jitterOf(clock, now) + SLACK + clock.steer;
}

/** How much longer than the least delay inputs take, in 19 of 20 cases, s. */
export function jitterOf(clock: Clock, now: number): number {
  return spreadOf(clock.up, now);
}

/**
 * An input that was sent under `steerThen` arrived `margin` s before it was needed (negative: late). What the steering has added
 * since it was sent is in flight already, and not asked for twice.
 */
export function steerByMargin(clock: Clock, margin: number, steerThen: number): void {
  const wanted = steerThen + SLACK / 2 - margin;
  if (wanted > clock.steer) clock.steer = Math.min(MAX_STEER, wanted);
}

/**
 * Moves the present to `now`.
 * @param deadZone wall s of error that is left alone: one substep
 * @returns whether it jumped: by a hard reset, or because it has just begun
 */
export function advanceClock(clock: Clock, now: number, deadZone: number): boolean {
  const elapsed = now - clock.updatedAt;
  clock.updatedAt = now;
  if (elapsed > 0) clock.steer = Math.max(0, clock.steer - elapsed * STEER_DECAY);
  const target = serverTime(clock, now) + leadOf(clock, now);
  const next = clock.present + Math.max(0, elapsed) * clock.rate;
  const error = target - next;
  if (!(Math.abs(error) <= HARD_RESET) || elapsed < -HARD_RESET) {
    clock.present = target;
    clock.rate = 1;
    clock.slewing = false;
    return true;
  }
  clock.present = next;
  clock.slewing = Math.abs(error) > (clock.slewing ? Math.min(SLEWED, deadZone) : deadZone);
  clock.rate = clock.slewing ? 1 + Math.max(-MAX_SLEW, Math.min(MAX_SLEW, error / SLEW_TIME)) : 1;
  return false;
}
