import { type Clock, leadOf, serverTime, slackOf } from './clock';

/** A larger error is corrected by a jump, s (PREDICTION, Clock). */
const HARD_RESET = 2;
/** After a clock jump, a larger error is corrected at once, s. */
const STEP = 0.1;
/** The same once an uncertain offset is certain again, s. */
const STEP_WHEN_CERTAIN = 0.008;
/** s: an offset is certain if its bounds are at most this much wider than the smallest round trip, uncertain beyond the second value. */
const TIGHT = 0.03;
const LOOSE = 0.06;
/** A present ahead by up to this waits for the server instead of going back, s. */
const MAX_WAIT = 0.8;
/** The present runs at most this much faster or slower than the wall. */
const MAX_SLEW = 0.1;
/** The rate's correction is the error over this time, s, so that a small error is not chased at full slew. */
const SLEW_TIME = 0.5;
/** A slew continues until the error is below this, s. */
const SLEWED = 0.001;
/** The steered lead decays at this rate, s/s. */
const STEER_DECAY = 0.004;
/** A frame that takes longer is an absence, s. */
const MAX_FRAME = 0.25;
/** Coarsest clock of a page, s. */
const MAX_CLOCK_STEP = 0.25;

/** Limits of the present's movement. */
export interface Pacing {
  /** Error that is tolerated, wall s: half a substep. */
  readonly deadZone: number;
  /** Server wall s that the present never passes: the newest frame plus the prediction horizon. */
  readonly latest: number;
}

/**
 * Moves the present to `now`.
 * @returns whether it jumped: after a clock jump, or because it has just started
 */
export function advanceClock(clock: Clock, now: number, { deadZone, latest }: Pacing): boolean {
  const elapsed = Number.isNaN(clock.updatedAt) ? 0 : Math.max(0, now - clock.updatedAt);
  clock.updatedAt = now;
  measureClockStep(clock, elapsed);
  clock.steer = Math.max(0, clock.steer - elapsed * STEER_DECAY);
  const aim = serverTime(clock, now) + leadOf(clock);
  const limit = Math.min(latest, clock.stoppedAt + leadOf(clock));
  const target = Math.min(aim, limit);
  const step = stepOf(clock);
  if (aim > limit || Math.abs(clock.offset - clock.settledOffset) > step) clock.stepped = true;
  // The rate is meant for one frame, not for an absence.
  const slewed = (clock.rate - 1) * Math.min(elapsed, MAX_FRAME);
  if (elapsed > MAX_FRAME) clock.wasLoose = true;
  const next = Math.min(clock.present + elapsed + slewed, Math.max(limit, clock.present));
  const error = target - next;
  const jumps = clock.stepped ? error > step || error < -MAX_WAIT : Math.abs(error) > HARD_RESET;
  if (jumps || Number.isNaN(error)) {
    jumpTo(clock, target);
    return true;
  }
  // A present that ran ahead of a stopped server waits until the server has caught up.
  if (clock.stepped && error < -(clock.rate === 0 ? deadZone : step)) {
    clock.rate = 0;
    return false;
  }
  clock.present = next;
  if (aim <= limit) settle(clock, step !== STEP);
  slew(clock, error, deadZone);
  return false;
}

/** The error, s, beyond which the present is corrected at once. */
function stepOf(clock: Clock): number {
  const slack = slackOf(clock);
  if (slack > LOOSE && slack < Number.POSITIVE_INFINITY) clock.wasLoose = true;
  return clock.wasLoose && slack <= TIGHT ? STEP_WHEN_CERTAIN : STEP;
}

function jumpTo(clock: Clock, target: number): void {
  clock.present = target;
  clock.rate = 1;
  clock.slewing = false;
  settle(clock, slackOf(clock) <= TIGHT);
}

/** The present follows the offset: the next step counts from here. */
function settle(clock: Clock, isCertain: boolean): void {
  clock.settledOffset = clock.offset;
  clock.stepped = false;
  if (isCertain) clock.wasLoose = false;
}

/** Sets the rate that reduces `error`; none within the dead zone, s. */
function slew(clock: Clock, error: number, deadZone: number): void {
  clock.slewing = Math.abs(error) > (clock.slewing ? Math.min(SLEWED, deadZone) : deadZone);
  clock.rate = clock.slewing ? 1 + Math.max(-MAX_SLEW, Math.min(MAX_SLEW, error / SLEW_TIME)) : 1;
}

/** Measures the smallest step of a coarse clock. */
function measureClockStep(clock: Clock, elapsed: number): void {
  if (elapsed === 0) {
    clock.stillCalls += 1;
    return;
  }
  if (clock.stillCalls > 0 && elapsed <= MAX_CLOCK_STEP)
    clock.clockStep = clock.clockStep === 0 ? elapsed : Math.min(clock.clockStep, elapsed);
  else if (elapsed < clock.clockStep * 0.9) clock.clockStep = 0;
  clock.stillCalls = 0;
}
