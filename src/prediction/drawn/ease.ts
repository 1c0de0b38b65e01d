import { dot, lengthOf } from './rotation';

/**
 * The drawn offset of one ship (PREDICTION, Drawing): drawn = predicted + offset, and the offset goes to zero as a
 * critically damped spring by elapsed time. In the reference body's axes, so that it turns with the ground.
 * The angular offset is one rotation vector on the left: drawn attitude = exp(offset) · predicted attitude, both as seen from the
 * body's axes. Simulation never reads any of it.
 *
 * The spring's speed is capped at 7.3 % of the correction in a 60 Hz frame, or 1.9 cm and 0.45° where that is more: uncapped, the
 * springs that come within 5 % in 300 ms (along the ground), 150 ms (along the normal) and 250 ms (in angle) would move by 10,
 * 19 and 12 % of a correction in one frame. Capped, the first and the last still do; the normal does up to 15 cm, and a larger
 * correction takes it up to 240 ms, the least that any curve can take at 8 % a frame.
 */
export interface Ease {
  /** m */
  readonly offset: Float64Array;
  /** m/s */
  readonly rate: Float64Array;
  /** rad */
  readonly turn: Float64Array;
  /** rad/s */
  readonly turnRate: Float64Array;
  /** Initial size of the correction in progress, m and rad. */
  size: number;
  turnSize: number;
  active: boolean;
}

/** Times after which a correction is within 5 %, s. */
export interface Smoothing {
  /** 0.1 to 2 s; 0.3 by default. */
  readonly alongGround: number;
  /** 0.05 to 2 s; 0.15 by default. The cap lengthens it for a correction of more than 15 cm. */
  readonly alongNormal: number;
  /** 0.1 to 2 s; 0.25 by default. */
  readonly angle: number;
}

export const DEFAULT_SMOOTHING: Smoothing = { alongGround: 0.3, alongNormal: 0.15, angle: 0.25 };
/** s, lowest and highest. */
export const SMOOTHING_BOUNDS: Readonly<Record<keyof Smoothing, readonly [number, number]>> = {
  alongGround: [0.1, 2],
  alongNormal: [0.05, 2],
  angle: [0.1, 2],
};

/** Springs for settle times. */
export interface Springs {
  /** Stiffness, 1/s. */
  readonly ground: number;
  readonly normal: number;
  readonly angle: number;
  /** Factor on the caps, ≥ 1: above 1 for settle times below the defaults. */
  readonly capFactor: number;
  readonly turnCapFactor: number;
}

/** The springs for the given settle times, which are within SMOOTHING_BOUNDS. */
export function springsOf(given: Partial<Smoothing> = {}): Springs {
  const usual = DEFAULT_SMOOTHING;
  const { alongGround, alongNormal, angle } = { ...usual, ...given };
  return {
    ground: GROUND * (usual.alongGround / alongGround),
    normal: NORMAL * (usual.alongNormal / alongNormal),
    angle: ANGLE * (usual.angle / angle),
    capFactor: capFactorFor(Math.max(usual.alongGround / alongGround, usual.alongNormal / alongNormal)),
    turnCapFactor: capFactorFor(usual.angle / angle),
  };
}

/** With the default caps exactly 5 % is left at the default times. Shorter times get a margin of 5 %. */
function capFactorFor(ratio: number): number {
  return ratio > 1 ? 1.05 * ratio : 1;
}

/** Stiffness, 1/s, of the default settle times. Each with its cap leaves less than 5 % at its time. */
const GROUND = 20;
const NORMAL = 60;
const ANGLE = 30;
/** Share of the correction per second, 1/s: 7.3 % in 1/60 s. */
const SHARE_CAP = 4.4;
/** m/s: 1.9 cm in 1/60 s. */
const SPEED_CAP = 1.15;
/** rad/s: 0.45° in 1/60 s. */
const TURN_CAP = 0.47;
/** s: longest interval between two applications of the caps, at any frame rate. */
const SLICE = 1 / 240;
/** s after which nothing visible is left. */
const FORGOTTEN = 2;
/** m and rad, invisible. */
const NOTHING = 1e-9;

export function createEase(): Ease {
  return {
    offset: new Float64Array(3),
    rate: new Float64Array(3),
    turn: new Float64Array(3),
    turnRate: new Float64Array(3),
    size: 0,
    turnSize: 0,
    active: false,
  };
}

/** Clears the offset: the drawn pose jumps to the predicted one. */
export function snap(ease: Ease): void {
  ease.offset.fill(0);
  ease.rate.fill(0);
  ease.turn.fill(0);
  ease.turnRate.fill(0);
  ease.size = 0;
  ease.turnSize = 0;
  ease.active = false;
}

/** A correction changed `offset` and `turn`; their rates continue, so that the drawn velocity does not jump. */
export function restartEase(ease: Ease): void {
  ease.size = lengthOf(ease.offset);
  ease.turnSize = lengthOf(ease.turn);
  ease.active = true;
}

/**
 * Lets `elapsed` s pass.
 * @param normal the local up at the ship, unit, in the body's axes
 * @param turning s of these since the turn began
 */
export function advanceEase(
  ease: Ease,
  normal: Float64Array,
  elapsed: number,
  springs: Springs,
  turning = elapsed,
): void {
  if (!ease.active || !(elapsed > 0)) return;
  if (elapsed > FORGOTTEN) {
    snap(ease);
    return;
  }
  const slices = Math.ceil((elapsed / SLICE) * Math.max(springs.capFactor, springs.turnCapFactor));
  const dt = elapsed / slices;
  for (let i = 0; i < slices; i++) {
    moveOffset(ease, normal, dt, springs);
    moveTurn(ease, turning / slices, springs);
  }
  if (lengthOf(ease.offset) + lengthOf(ease.turn) + lengthOf(ease.rate) + lengthOf(ease.turnRate) < NOTHING)
    snap(ease);
}

function moveOffset(ease: Ease, normal: Float64Array, dt: number, springs: Springs): void {
  const { offset, rate } = ease;
  const { ground: stiff, normal: stiffUp, capFactor } = springs;
  const decayGround = Math.exp(-stiff * dt);
  const decayNormal = Math.exp(-stiffUp * dt);
  const high = dot(offset, normal);
  const climb = dot(rate, normal);
  const highPush = climb + stiffUp * high;
  const highNext = (high + highPush * dt) * decayNormal;
  const climbNext = (climb - stiffUp * highPush * dt) * decayNormal;
  for (let k = 0; k < 3; k++) {
    const n = normal[k]!;
    const x = offset[k]! - high * n;
    const v = rate[k]! - climb * n;
    const push = v + stiff * x;
    wanted.step[k] = (x + push * dt) * decayGround + highNext * n - offset[k]!;
    wanted.speed[k] = (v - stiff * push * dt) * decayGround + climbNext * n;
  }
  move(offset, rate, wanted, dt, capFactor * Math.max(SPEED_CAP, SHARE_CAP * ease.size));
}

function moveTurn(ease: Ease, dt: number, { angle: stiff, turnCapFactor }: Springs): void {
  const { turn, turnRate } = ease;
  const decay = Math.exp(-stiff * dt);
  for (let k = 0; k < 3; k++) {
    const push = turnRate[k]! + stiff * turn[k]!;
    wanted.step[k] = (turn[k]! + push * dt) * decay - turn[k]!;
    wanted.speed[k] = (turnRate[k]! - stiff * push * dt) * decay;
  }
  move(turn, turnRate, wanted, dt, turnCapFactor * Math.max(TURN_CAP, SHARE_CAP * ease.turnSize));
}

/** The uncapped spring's motion in a slice. */
interface Move {
  /** m or rad */
  readonly step: Float64Array;
  /** At its end, m/s or rad/s. */
  readonly speed: Float64Array;
}

/** value += step, rate = speed, both no faster than `cap`. */
function move(value: Float64Array, rate: Float64Array, { step, speed }: Move, dt: number, cap: number): void {
  const stepped = lengthOf(step) / dt;
  const moving = lengthOf(speed);
  const stepShare = stepped > cap ? cap / stepped : 1;
  const speedShare = moving > cap ? cap / moving : 1;
  for (let k = 0; k < 3; k++) {
    value[k] = value[k]! + step[k]! * stepShare;
    rate[k] = speed[k]! * speedShare;
  }
}

const wanted: Move = { step: new Float64Array(3), speed: new Float64Array(3) };
