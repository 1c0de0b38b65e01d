/** One touch and what follows, with no axis in particular: the card's numbers by the formulas of vectors. */
import { describe, expect, it } from 'vitest';
import {
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  BODY_STRIDE,
  CONTACT,
  CRASHED,
  FLYING,
  IMPACT_SPEED,
  LANDED,
  POSITION,
  SHIP_CLASSES,
  SHIP_STRIDE,
  SURFACE_STATE,
  THRUST_LEVEL,
  TIPPED,
  VELOCITY,
  type Vec3,
  type World,
} from '../../../src/dynamics';
import {
  beginLog,
  createTouchdownView,
  fillTouchdown,
  LOG_STRIDE,
  LOGGED_STATE,
  logSubstep,
} from '../../../src/prediction/touchdown/touchdownLog';
import { cross, plus, product, times, turnAbout, unit } from '../../dynamics/vectors';

/** Of a small body, so that its turning moves the ground by metres per second. */
const RADIUS = 5000;
const SPIN: Vec3 = [3e-4, 5e-4, -2e-4];
const UP = unit([2, -3, 6]);
const EAST = unit(cross(UP, [1, 2, 2]));
const PLACE = times(UP, RADIUS);
const DT = 0.01;
const GRAVITY = 1.6;
const WORLD = {
  bodies: [{ gravityParameter: GRAVITY * RADIUS ** 2 }],
  shipClasses: [SHIP_CLASSES[0]!],
} as unknown as World;

interface Moment {
  /** Speeds relative to the turning ground, m/s. */
  readonly east?: number;
  readonly up?: number;
  readonly state?: number;
  /** Angle between the ship's nose and up, rad. */
  readonly tilt?: number;
  readonly thrust?: number;
  readonly impact?: number;
  readonly crashed?: boolean;
}

/** The nose, +Z, turned to UP, then by `tilt` about EAST. */
function attitudeAt(tilt: number) {
  const axis = unit(cross([0, 0, 1], UP));
  return product(turnAbout(EAST, tilt), turnAbout(axis, Math.acos(UP[2])));
}

function rowOf({ east = 0, up = 0, state = CONTACT, tilt = 0, thrust = 0, impact = 0, crashed }: Moment) {
  const row = new Float64Array(SHIP_STRIDE);
  row.set(PLACE, POSITION);
  row.set(plus(cross(SPIN, PLACE), plus(times(EAST, east), UP, up)), VELOCITY);
  row.set(attitudeAt(tilt), ATTITUDE);
  row[SURFACE_STATE] = state;
  row[THRUST_LEVEL] = thrust;
  row[IMPACT_SPEED] = impact;
  row[CRASHED] = crashed ? 1 : 0;
  return row;
}

/** The card after these moments, one substep apart; each stands for `times` of them. */
function cardAfter(...moments: readonly (Moment & { readonly times?: number })[]) {
  const bodies = new Float64Array(BODY_STRIDE);
  bodies.set(SPIN, BODY_ANGULAR_VELOCITY);
  const log = new Float64Array(LOG_STRIDE);
  const rows = moments.flatMap((moment) => Array.from({ length: moment.times ?? 1 }, () => rowOf(moment)));
  beginLog(log, rows[0]![SURFACE_STATE]!);
  rows.slice(1).forEach((row, i) => {
    logSubstep(log, WORLD, { before: rows[i]!, beforeAt: 0, rows: row, at: 0, bodies, dt: [DT, null!] });
  });
  const card = createTouchdownView();
  fillTouchdown(card, log, true);
  return card;
}

const flying: Moment = { state: FLYING, east: 3, up: -2 };
const touching: Moment = { east: 3, impact: 2 };

describe('a touch', () => {
  it('has the impact speed of the dynamics, and the speed along the turning ground before it', () => {
    const card = cardAfter(flying, { east: 1, impact: 2 });
    expect(card).toMatchObject({ known: true, outcome: 'open', verticalSpeed: 2, bounces: 0 });
    expect(card.horizontalSpeed).toBeCloseTo(3, 9);
  });

  it('has the largest tilt of the nose from up, before the touch or after', () => {
    const tilts = (...angles: number[]) =>
      cardAfter({ ...flying, tilt: angles[0]! }, ...angles.slice(1).map((tilt) => ({ ...touching, tilt })));
    expect(tilts(0.3, 0.2, 0.1).largestTilt).toBeCloseTo(0.3, 9);
    expect(tilts(0.1, 0.2, -0.4, 0.3).largestTilt).toBeCloseTo(0.4, 9);
    expect(tilts(0, 2.5).largestTilt).toBeCloseTo(2.5, 9);
  });

  it('slides by the speed along the ground, up and down left out', () => {
    const card = cardAfter(flying, { ...touching, times: 101, up: 0.5 });
    expect(card.slideMetres).toBeCloseTo(3, 9);
  });

  it('is timed from the touch to rest', () => {
    const card = cardAfter(flying, { ...touching, times: 51 }, { state: LANDED, times: 20 });
    expect(card).toMatchObject({ outcome: 'landed' });
    expect(card.settleSeconds).toBeCloseTo(0.51, 9);
  });
});

describe('the card after a touch', () => {
  const tipped = { state: TIPPED, tilt: 1.5 };

  it('is closed while the ship is tipped, and open again once it is righted, timed from the touch', () => {
    const down = cardAfter(flying, touching, { ...tipped, times: 30 });
    expect(down).toMatchObject({ outcome: 'tipped', bounces: 0 });
    expect(down.settleSeconds).toBeCloseTo(0.01, 9);
    const righted = cardAfter(flying, touching, { ...tipped, times: 30 }, { times: 5 });
    expect(righted.outcome).toBe('open');
    expect(righted.settleSeconds).toBeCloseTo(0.35, 9);
    const landed = cardAfter(
      flying,
      touching,
      { ...tipped, times: 30 },
      { times: 5 },
      { state: LANDED, times: 9 },
    );
    expect(landed.outcome).toBe('landed');
    expect(landed.settleSeconds).toBeCloseTo(0.36, 9);
  });

  it('is replaced by that of a touch after rest', () => {
    const again = { ...touching, impact: 1.5, east: 1 };
    const card = cardAfter(flying, touching, { state: LANDED, times: 9 }, flying, again);
    expect(card).toMatchObject({
      known: true,
      outcome: 'open',
      verticalSpeed: 1.5,
      bounces: 0,
      slideMetres: 0,
    });
    expect(card.largestTilt).toBe(0);
  });

  it('of a crash on the ground has the speed of the touch', () => {
    const card = cardAfter(flying, touching, touching, { ...touching, crashed: true, times: 5 });
    expect(card).toMatchObject({ outcome: 'crashed', verticalSpeed: 2, bounces: 0 });
    expect(card.settleSeconds).toBeCloseTo(0.02, 9);
    expect(card.slideMetres).toBeCloseTo(0.06, 9);
  });

  it('is unknown for a ship first seen on the ground', () => {
    expect(cardAfter({ tilt: 0.5 }, { ...touching, times: 9 }, { state: LANDED })).toMatchObject({
      known: false,
    });
  });
});

describe('a hop', () => {
  /** Drop of a ship's own height after a rise at 1 m/s: the time of the parabola, s. */
  const drop = SHIP_CLASSES[0]!.groundContactOffset;
  const longest = (2 * (1 + Math.sqrt(1 + 2 * GRAVITY * drop))) / GRAVITY;
  const hop = (seconds: number, thrust: number) =>
    cardAfter(
      flying,
      touching,
      { state: FLYING, up: 1, times: Math.round(seconds / DT), thrust },
      { ...touching, impact: 1 },
    );

  it('under thrust is a bounce up to twice the time without; then it is a new approach', () => {
    expect(hop(longest - 0.05, 0.1)).toMatchObject({ bounces: 1, verticalSpeed: 2 });
    expect(hop(longest + 0.05, 0.1)).toMatchObject({ bounces: 0, verticalSpeed: 1 });
  });

  it('without thrust is a bounce however long it takes', () => {
    expect(hop(longest + 5, 0)).toMatchObject({ bounces: 1, verticalSpeed: 2 });
  });
});

describe('a second hop', () => {
  const LONG = 4;
  const up = (seconds: number, thrust: number) =>
    ({ state: FLYING, up: 1, times: Math.round(seconds / DT), thrust }) as const;
  const ground = { ...touching, impact: 1, tilt: 0.1 };

  it('is timed separately, with thrust of its own', () => {
    // A hop may last 8.9 s under thrust.
    const twice = cardAfter(flying, ground, up(6, 0.1), ground, up(6, 0.1), ground);
    expect(twice).toMatchObject({ known: true, bounces: 2 });
    const coasting = cardAfter(flying, ground, up(LONG, 0.1), ground, up(12, 0), ground);
    expect(coasting).toMatchObject({ known: true, bounces: 2 });
  });

  it('keeps the largest tilt of the touches before', () => {
    const card = cardAfter(flying, { ...ground, tilt: 0.3 }, up(LONG, 0), ground);
    expect(card.largestTilt).toBeCloseTo(0.3, 9);
  });
});

it('a log begins in the state in which the ship is first seen', () => {
  const log = new Float64Array(LOG_STRIDE).fill(7);
  beginLog(log, TIPPED);
  expect(log[LOGGED_STATE]).toBe(TIPPED);
  expect(log.reduce((sum, x) => sum + x, 0)).toBe(TIPPED);
});

describe('a crash from flight', () => {
  it('has the speed towards the ground, and is closed at once', () => {
    const card = cardAfter(flying, { ...flying, crashed: true }, { ...flying, crashed: true, times: 9 });
    expect(card).toMatchObject({ known: true, outcome: 'crashed', settleSeconds: 0 });
    expect([card.verticalSpeed, card.horizontalSpeed]).toEqual([expect.closeTo(2, 9), expect.closeTo(3, 9)]);
  });

  it('has speed 0 if the ship was rising', () => {
    expect(cardAfter({ ...flying, up: 2 }, { ...flying, up: 2, crashed: true }).verticalSpeed).toBe(0);
  });
});
