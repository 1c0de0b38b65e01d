import { addDelay, createDelays, type Delays, minDelay, lowerDelay, spreadOf } from './delays';
import {
  boundAbove,
  boundBelow,
  boundBothSides,
  createOffsetBounds,
  forgetBounds,
  type OffsetBounds,
  type Sampling,
  forgetLower,
} from './offsetBounds';

/**
 * The server's clock as estimated by the client, and the present that is drawn (PREDICTION, Clock).
 * All times are wall seconds: `now` is an argument, the client's; server time counts from the timeline's origin. The offset lies between
 * two bounds, and half way between them if both directions take equally long. With the lead added that assumption cancels: what counts is when
 * inputs arrive.
 */
export interface Clock {
  readonly bounds: OffsetBounds;
  /** Upstream delays of pings above the smallest, and round trips, s. */
  readonly up: Delays;
  readonly roundTrips: Delays;
  /** Client − server time, s; NaN before the first sample. */
  offset: number;
  /** When the offset was last estimated, client s. */
  offsetAt: number;
  /** The offset when the present was last on target. */
  settledOffset: number;
  /** Added to the lead because inputs arrived late, s; and the last late input, which a second one must confirm before it counts. */
  steer: number;
  lateAt: number;
  lateWanted: number;
  /** Server time that is drawn: estimate + lead, slewed. NaN before the first sample. */
  present: number;
  /** Rate of the present: 0.9 … 1.1, 0 while it waits for the server. */
  rate: number;
  slewing: boolean;
  /** Bounds contradicted each other, or the present was held: the error is corrected at once. */
  stepped: boolean;
  /** The offset has been uncertain since the present was last on target. */
  wasLoose: boolean;
  updatedAt: number;
  /** Latest round trip, s, smoothed. */
  roundTrip: number;
  /** When a ping was last answered, and last answered with a usable time, client s; and that answer's server time. */
  pongAt: number;
  timedPongAt: number;
  answeredAt: number;
  /** Server time at which the server stopped, by its last answer; infinite while it runs. */
  stoppedAt: number;
  /** Smallest step of the page's clock, s; 0 for a fine one. */
  clockStep: number;
  stillCalls: number;
}

/** Without a pong, half of this is the assumed delay downstream, s. */
const ASSUMED_ROUND_TRIP = 0.1;
/** Slack between an input's arrival and its stamp, in addition to the jitter, s. */
const SLACK = 0.01;
/** Bounds no wider than this give the delay of a ping, s. */
const CERTAIN = 0.006;
/** Largest lead, whatever the margins are, s. */
const MAX_STEER = 1;
/** A delay this far above the smallest is a stall, not jitter: no lead compensates for it, s. */
const STALL = 0.3;
/** s: two late inputs at least this far apart are separate, and at most this far apart confirm each other. */
const TWO_LATE = [0.3, 10] as const;
/** Changes of the offset up to AVERAGED, s, are averaged over a time, s, which is shorter for the first few pings. */
const AVERAGED = 0.01;
const OVER = 2;
const SETTLED_AFTER = 80;
/** Pings that were sent further apart than this but reached the server within it waited in the same queue, s. */
const ONE_QUEUE = 0.01;
/** Pings count as answered if one was answered within this, s. */
const PONGS_HEARD = 3;

export function createClock(): Clock {
  return {
    bounds: createOffsetBounds(),
    up: createDelays(256),
    roundTrips: createDelays(50),
    offset: Number.NaN,
    offsetAt: Number.NEGATIVE_INFINITY,
    settledOffset: Number.NaN,
    steer: 0,
    lateAt: Number.NEGATIVE_INFINITY,
    lateWanted: 0,
    present: Number.NaN,
    rate: 1,
    slewing: false,
    stepped: false,
    wasLoose: false,
    updatedAt: Number.NaN,
    roundTrip: Number.NaN,
    pongAt: Number.NEGATIVE_INFINITY,
    timedPongAt: Number.NEGATIVE_INFINITY,
    answeredAt: Number.NEGATIVE_INFINITY,
    stoppedAt: Number.POSITIVE_INFINITY,
    clockStep: 0,
    stillCalls: 0,
  };
}

/**
 * Takes the arrival of a message that the server sent at server time `sentAt`.
 * @param isOverdue whether none came for longer than usual
 */
export function sampleDown(clock: Clock, sentAt: number, now: number, isOverdue = false): void {
  if (boundAbove(clock.bounds, sentAt, now, samplingOf(clock, now, isOverdue))) clock.stepped = true;
  if (sentAt >= clock.stoppedAt) clock.stoppedAt = Number.POSITIVE_INFINITY;
  settleOffset(clock, now);
}

/** Whether the server has ever answered a ping. */
export function answersPings({ pongAt }: Clock): boolean {
  return pongAt > Number.NEGATIVE_INFINITY;
}

function samplingOf(clock: Clock, now: number, isOverdue: boolean): Sampling {
  return {
    roundTrip: leastRoundTrip(clock),
    clockStep: clock.clockStep,
    hearsPongs: now - clock.timedPongAt <= PONGS_HEARD,
    isOverdue: isOverdue && !answersPings(clock),
  };
}

/** When a pong was sent, server s. */
export interface Answer {
  readonly at: number;
  /** The server had stopped: its next tick was overdue. */
  readonly hasStopped: boolean;
}

/** Takes the pong for a ping of client time `pinged`; `answer` is null if its time is unusable. */
export function samplePong(clock: Clock, pinged: number, answer: Answer | null, now: number): void {
  const roundTrip = now - pinged;
  if (!(roundTrip >= 0)) return;
  const ofOneQueue = now - clock.pongAt < ONE_QUEUE && clock.roundTrips.count > 0;
  if (ofOneQueue) lowerDelay(clock.roundTrips, roundTrip);
  else addDelay(clock.roundTrips, roundTrip);
  clock.pongAt = now;
  clock.roundTrip = Number.isNaN(clock.roundTrip) ? roundTrip : clock.roundTrip * 0.8 + roundTrip * 0.2;
  if (answer === null) return;
  const answered = answer.at;
  clock.timedPongAt = now;
  clock.stoppedAt = answer.hasStopped ? answered : Number.POSITIVE_INFINITY;
  if (answer.hasStopped) boundBelow(clock.bounds, { pinged, stopped: answered, now });
  else if (boundBothSides(clock.bounds, { pinged, answered, now }, clock.clockStep)) clock.stepped = true;
  settleOffset(clock, now);
  // A stall is one sample, however many pings waited in it, and does not count as jitter.
  const counts =
    !answer.hasStopped && roundTrip <= leastRoundTrip(clock) + STALL && slackOf(clock) <= CERTAIN;
  // Measured from the lower bound, the fastest upstream path: the offset also depends on downstream delays.
  if (counts && answered - clock.answeredAt > ONE_QUEUE)
    addDelay(clock.up, answered - pinged + clock.bounds.lower);
  clock.answeredAt = answered;
}

/** Estimates the offset. The middle of the bounds varies with the last few delays, so small changes are averaged. */
function settleOffset(clock: Clock, now: number): void {
  const middle = middleOf(clock);
  const elapsed = Math.max(0, now - clock.offsetAt);
  const change = middle - clock.offset;
  const over = OVER * Math.min(1, clock.roundTrips.count / SETTLED_AFTER);
  const isAveraged = Math.abs(change) <= AVERAGED && elapsed < over;
  clock.offset = isAveraged ? clock.offset + (change * elapsed) / over : middle;
  clock.offsetAt = now;
}

function middleOf(clock: Clock): number {
  const { upper, lower } = clock.bounds;
  const half = leastRoundTrip(clock) / 2;
  if (lower === Number.NEGATIVE_INFINITY) return upper - half;
  return upper === Number.POSITIVE_INFINITY ? lower + half : (upper + lower) / 2;
}

/** How much wider the bounds of the offset are than the least round trip, s; infinite if either is unknown. */
export function slackOf(clock: Clock): number {
  return clock.bounds.upper - clock.bounds.lower - leastRoundTrip(clock);
}

function leastRoundTrip(clock: Clock): number {
  const least = minDelay(clock.roundTrips);
  return Number.isNaN(least) ? ASSUMED_ROUND_TRIP : least;
}

/** Forgets all but the delays: the server's schedule has changed. */
export function forgetSchedule(clock: Clock): void {
  forgetBounds(clock.bounds);
  clock.offset = Number.NaN;
  clock.present = Number.NaN;
  clock.answeredAt = Number.NEGATIVE_INFINITY;
  clock.stoppedAt = Number.POSITIVE_INFINITY;
}

/** Estimated server time at which a message that arrives now was sent. */
export function sentAt(clock: Clock, now: number): number {
  return serverTime(clock, now) - leastRoundTrip(clock) / 2;
}

/** Estimated server time now, if the server runs; NaN before the first sample. */
export function serverTime(clock: Clock, now: number): number {
  return now - clock.offset;
}

/** How far the present runs ahead of the server so that inputs arrive in time, s: half the round trip + jitter + slack + steering. */
export function leadOf(clock: Clock): number {
  return leastRoundTrip(clock) / 2 + jitterOf(clock) + SLACK + clock.steer;
}

/** Delay above the smallest that 19 of 20 inputs do not exceed, s; stalls are not counted. */
export function jitterOf(clock: Clock): number {
  return spreadOf(clock.up, STALL);
}

/**
 * Steers by an input that arrived `margin` s before it was needed (negative: late), sent under steering `steerThen`. Steering added
 * since then is not added again. A stall must not steer: only a second late input, some time later, counts.
 */
export function steerByMargin(clock: Clock, margin: number, steerThen: number, now: number): void {
  const wanted = Math.min(MAX_STEER, steerThen + SLACK / 2 - margin);
  if (wanted <= clock.steer || -margin > STALL) return;
  const since = now - clock.lateAt;
  if (since < TWO_LATE[0]) return;
  if (since <= TWO_LATE[1]) clock.steer = Math.max(clock.steer, Math.min(wanted, clock.lateWanted));
  clock.lateAt = now;
  clock.lateWanted = wanted;
}

/** The caller's clock was set back: an unknown time has passed. */
export function noteSetBack(clock: Clock): void {
  forgetLower(clock.bounds);
  clock.lateAt = Number.NEGATIVE_INFINITY;
}
