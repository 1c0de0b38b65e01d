import type { BodyState, PartialFrame, ShipState } from '../../../wire';

/**
 * Game time from one tick to the next, measured from motion (PREDICTION, Timeline): a server may
 * omit its time scale, or vary it by a few per cent to stay in step with a calendar.
 */
export interface GameTimeMeter {
  tick: number;
  gameTime: number;
  bodies: readonly BodyState[];
  ships: readonly ShipState[];
  /** Measurements that contradict the tempo sent, game s per tick: the number in a row that agree, and the last one. */
  agreeing: number;
  last: number;
  /** The accepted measurement, game s per tick; NaN while the tempo sent fits. */
  perTick: number;
}

/** Relative accuracy of a source: a measurement closer than this to the tempo sent agrees with it. */
const EXACT = 1e-3;
const BY_SHIPS = 0.02;
/** Consecutive measurements that must agree, by accuracy. */
const NEEDED = 2;
const NEEDED_BY_SHIPS = 3;
/** m/s: slower motions are not measured. */
const MIN_SPEED = 1;

export function createGameTimeMeter(): GameTimeMeter {
  return {
    tick: -1,
    gameTime: Number.NaN,
    bodies: [],
    ships: [],
    agreeing: 0,
    last: Number.NaN,
    perTick: Number.NaN,
  };
}

/** The measured part of a frame. */
type Measured = Pick<PartialFrame, 'tick' | 'gameTime' | 'ships'> & {
  readonly tickRate: number;
  readonly bodies: readonly BodyState[];
};

/** Measures a received frame; the first one begins the measurement. */
export function gameTimeScale(
  receiver: { gameTime: GameTimeMeter | null },
  frame: Measured,
  sent: number | null,
): number | null {
  receiver.gameTime ??= createGameTimeMeter();
  return measureGameTime(receiver.gameTime, frame, sent);
}

/**
 * Measures a frame.
 * @param sent the frame's own time scale, or null
 * @returns the measured time scale if the one sent is absent or does not fit; otherwise null
 */
export function measureGameTime(meter: GameTimeMeter, frame: Measured, sent: number | null): number | null {
  const { tickRate } = frame;
  const ticks = frame.tick - meter.tick;
  if (ticks <= 0) return scaleOf(meter, tickRate);
  const byClock = (frame.gameTime ?? Number.NaN) - meter.gameTime;
  const exact = Number.isNaN(byClock) ? byBodies(meter.bodies, frame.bodies) : byClock;
  const seconds =
    meter.tick < 0 ? Number.NaN : Number.isNaN(exact) ? byShips(meter.ships, frame.ships) : exact;
  meter.tick = frame.tick;
  meter.gameTime = frame.gameTime ?? Number.NaN;
  meter.bodies = frame.bodies;
  meter.ships = frame.ships;
  if (seconds > 0)
    acceptMeasurement(meter, seconds / ticks, {
      sent: (sent ?? 1) / tickRate,
      isExact: !Number.isNaN(exact),
    });
  return scaleOf(meter, tickRate);
}

function scaleOf({ perTick }: GameTimeMeter, tickRate: number): number | null {
  return Number.isNaN(perTick) ? null : perTick * tickRate;
}

function acceptMeasurement(
  meter: GameTimeMeter,
  perTick: number,
  { sent, isExact }: { readonly sent: number; readonly isExact: boolean },
): void {
  const tolerance = isExact ? EXACT : BY_SHIPS;
  if (near(perTick, sent, tolerance)) {
    meter.agreeing = 0;
    meter.perTick = Number.NaN;
    return;
  }
  if (near(perTick, meter.perTick, tolerance)) return;
  // A scale that varies by a few per cent changes from tick to tick, and is accepted as measured.
  const alike = near(perTick, meter.last, isExact ? 0.02 : BY_SHIPS);
  meter.agreeing = alike ? meter.agreeing + 1 : 1;
  meter.last = perTick;
  if (meter.agreeing >= (isExact ? NEEDED : NEEDED_BY_SHIPS)) meter.perTick = perTick;
}

function near(a: number, b: number, tolerance: number): boolean {
  return Math.abs(a - b) <= tolerance * Math.abs(b);
}

/** Game s between two states of the bodies, from the distances covered: the median of all that move; NaN if none does. */
function byBodies(before: readonly BodyState[], after: readonly BodyState[]): number {
  return medianOf(
    after.map((body, i) => {
      const old = before[i]?.name === body.name ? before[i] : before.find(({ name }) => name === body.name);
      return old === undefined ? Number.NaN : secondsBetween(old, body);
    }),
  );
}

/** The same for ships that fly without thrust. */
function byShips(before: readonly ShipState[], after: readonly ShipState[]): number {
  const byId = new Map(before.filter(isShip).map((ship) => [ship.shipId, ship]));
  return medianOf(
    after.filter(isShip).map((ship) => {
      const old = byId.get(ship.shipId);
      return old !== undefined && coasts(old) && coasts(ship) ? secondsBetween(old, ship) : Number.NaN;
    }),
  );
}

function coasts(ship: ShipState): boolean {
  return (
    ship.surfaceContactState === '' &&
    ship.landedBodyName === '' &&
    ship.thrustLevel === 0 &&
    Array.isArray(ship.translationInput) &&
    ship.translationInput.every((input) => input === 0)
  );
}

/** Distance divided by mean velocity; NaN without motion, or if either is not a vector. */
function secondsBetween(
  a: Pick<ShipState, 'position' | 'velocity'>,
  b: Pick<ShipState, 'position' | 'velocity'>,
): number {
  let along = 0;
  let square = 0;
  for (let k = 0; k < 3; k++) {
    const mean = (component(a.velocity, k) + component(b.velocity, k)) / 2;
    along += (component(b.position, k) - component(a.position, k)) * mean;
    square += mean * mean;
  }
  return square >= MIN_SPEED * MIN_SPEED && along !== 0 ? along / square : Number.NaN;
}

/** A component of a vector that a JavaScript caller may have omitted. */
function component(vector: unknown, k: number): number {
  const value: unknown = Array.isArray(vector) ? vector[k] : undefined;
  return typeof value === 'number' ? value : Number.NaN;
}

function isShip(ship: unknown): boolean {
  return typeof ship === 'object' && ship !== null;
}

function medianOf(values: readonly number[]): number {
  const known = values.filter((value) => !Number.isNaN(value)).sort((a, b) => a - b);
  return known.length === 0 ? Number.NaN : known[Math.floor((known.length - 1) / 2)]!;
}
