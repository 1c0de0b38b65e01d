import { describe, expect, it } from 'vitest';
import {
  BODIES,
  type Body,
  type BodyMotion,
  BODY_STRIDE,
  loadBody,
  loadControls,
  loadSettings,
  loadShipClass,
  loadTiming,
  loadWorld,
  NEUTRAL_CONTROLS,
  SHIP_STRIDE,
  type ShipInit,
  spawnShip,
  type World,
  flatTerrain,
  writeBodyMotion,
} from '../../../src/dynamics';
import { LANDER, must } from '../provingGround';
import { reasonOf } from './hostile';
import RANGES from './ranges.json';

/**
 * ranges.json holds, per record and field, values that must be refused by the field's name and values that must be taken. The Python
 * server's test_loading.py reads the same table, so that neither side takes what the other refuses.
 */

const LUNA = BODIES[0]!;
const WORLD: World = must(
  loadWorld({ settings: {}, shipClasses: [LANDER], bodies: [LUNA], terrainHeight: flatTerrain }),
);
const SHIP: ShipInit = {
  shipClass: LANDER.name,
  referenceBody: LUNA.name,
  relativePosition: [0, 0, 1.8e6],
  relativeVelocity: [0, 0, 0],
  attitude: [0, 0, 0, 1],
  angularVelocity: [0, 0, 0],
  fuel: 10,
  surfaceContactState: '',
  contactImpactSpeed: 0,
  crashed: false,
};

/** What each record is loaded by, with one field changed: the reason, or 'accepted'. */
const LOADERS: Readonly<Record<keyof typeof RANGES, (change: object) => string>> = {
  settings: (change) => reasonOf(loadSettings(change)),
  ship_class: (change) => reasonOf(loadShipClass({ ...LANDER, ...change })),
  body: (change) => bodyReason({ ...LUNA, ...change }),
  ship: (change) => spawnShip(new Float64Array(SHIP_STRIDE), 0, { ...SHIP, ...change }, WORLD) ?? 'accepted',
  controls: (change) => reasonOf(loadControls({ ...NEUTRAL_CONTROLS, ...change })),
  timing: (change) => {
    const { tickRate, timeScale } = { tickRate: 1, timeScale: 1, ...change };
    return reasonOf(loadTiming(tickRate, timeScale, WORLD.settings));
  },
};

function bodyReason(body: Body & BodyMotion): string {
  const loaded = loadBody(body);
  return loaded.ok ? (writeBodyMotion(new Float64Array(BODY_STRIDE), 0, body) ?? 'accepted') : loaded.reason;
}

/** JSON has no NaN and no infinities. */
const NOT_IN_JSON = new Map<unknown, number>([
  ['#nan', NaN],
  ['#inf', Infinity],
  ['#-inf', -Infinity],
]);

function valueOf(given: unknown): unknown {
  return Array.isArray(given) ? given.map(valueOf) : (NOT_IN_JSON.get(given) ?? given);
}

const camelCase = (name: string) => name.replace(/_(.)/g, (_, letter: string) => letter.toUpperCase());

const camelKeys = (record: object) =>
  Object.fromEntries(Object.entries(record).map(([name, value]) => [camelCase(name), value as unknown]));

interface Values {
  readonly refused: readonly unknown[];
  readonly accepted: readonly unknown[];
  /** What else of the record differs, for all of these values. */
  readonly with?: object;
}

/** Every field of the table, with what loads it. */
const FIELDS = Object.entries(RANGES).flatMap(([record, fields]) =>
  Object.entries<Values>(fields).map(([field, values]) => ({
    field: `${record}.${field}`,
    name: camelCase(field),
    load: (change: object) =>
      LOADERS[record as keyof typeof RANGES]({ ...camelKeys(values.with ?? {}), ...change }),
    ...values,
  })),
);

describe('the ranges that both sides share', () => {
  it.each(FIELDS)('$field is refused by its name', ({ name, load, refused }) => {
    for (const given of refused)
      expect(load({ [name]: valueOf(given) }), JSON.stringify(given)).toMatch(
        new RegExp(`(^|[ :])${name}(\\[\\d\\])*: `),
      );
  });

  it.each(FIELDS)('$field is taken up to the ends of its range', ({ name, load, accepted }) => {
    for (const given of accepted)
      expect(load({ [name]: valueOf(given) }), JSON.stringify(given)).toBe('accepted');
  });
});
