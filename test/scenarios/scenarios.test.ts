import { describe, expect, it } from 'vitest';
import {
  EVENT_NAMES,
  NEUTRAL_CONTROLS,
  readBodyMotion,
  readShip,
  BODY_STRIDE,
  SHIP_STRIDE,
} from '../../src/dynamics';
import {
  fleetOrders,
  fromBodyRelative,
  pilotAt,
  runScenario,
  type ScenarioRun,
  type Scenario,
  SCENARIOS,
  loadScenario,
} from '../../src/scenarios';
import { scheduleOf, type ScheduledInput } from '../../src/scenarios/runTick';
import { valueOf } from '../authority/moon';
import golden from './golden.json';

const NAMED = SCENARIOS.map((scenario) => [scenario.name, scenario] as const);
const named = (name: string) => SCENARIOS.find((scenario) => scenario.name === name)!;

function types({ events }: ScenarioRun) {
  return events.map(({ type }) => type);
}

/** Game seconds at which each event is visible. */
function times({ events, loaded }: ScenarioRun): number[] {
  const { substeps, dt } = loaded.timing;
  return events.map(({ tick, substep }) => (tick * substeps + substep + 1) * dt);
}

/** The ship at a tick, as seen from the scenario's site. */
function seenAt({ loaded, ships, bodies, world }: ScenarioRun, tick: number) {
  const body = { ...loaded.body, ...readBodyMotion(bodies, tick * BODY_STRIDE) };
  const { site } = loaded.scenario;
  const ship = readShip(ships, tick * SHIP_STRIDE, world);
  return fromBodyRelative(ship, loaded.shipClass, { body, site, terrainHeight: loaded.terrainHeight });
}

describe('scenarios', () => {
  it('have a unique name, a title and a description', () => {
    expect(new Set(SCENARIOS.map(({ name }) => name)).size).toBe(SCENARIOS.length);
    for (const { name, title, about } of SCENARIOS) {
      expect(name).toMatch(/^[a-z-]+$/);
      expect(title.length).toBeGreaterThan(3);
      expect(about.endsWith('.')).toBe(true);
    }
  });

  it('cover all events and all bodies', () => {
    const events = new Set(SCENARIOS.flatMap(({ expected }) => expected));
    expect([...events].sort()).toEqual(EVENT_NAMES.filter((name) => name !== '').sort());
    expect([...new Set(SCENARIOS.map(({ body }) => body))].sort()).toEqual([
      'Earth',
      'Luna',
      'Mars',
      'Phobos',
    ]);
  });

  // 0.3 Hz is a tick of 3.3 s in 334 substeps shorter than 0.01 s: other bits, the same outcome.
  it.each(NAMED)(
    '%s makes legal transitions only, and ends as declared, at any tick rate',
    (_name, scenario) => {
      for (const tickRate of [0.3, 1, 5, 20, 100]) {
        const run = valueOf(runScenario({ ...scenario, tickRate }));
        expect(run.illegalTransitions).toEqual([]);
        expect(types(run), `${tickRate} Hz`).toEqual(scenario.expected);
      }
    },
  );

  it.each(NAMED)(
    '%s keeps its pinned hash (else: node test/run.mjs test/scenarios/writeGolden.ts)',
    (name, scenario) => {
      const { hash } = valueOf(runScenario(scenario));
      expect(hash.toString(16)).toBe((golden as Record<string, string>)[name]);
    },
  );

  it.each(NAMED)('%s ends on the ground, crashed, or at its duration', (_name, scenario) => {
    const run = valueOf(runScenario(scenario));
    const last = run.ships.length / SHIP_STRIDE - 1;
    const { position, velocity } = seenAt(run, last);
    expect([...position, ...velocity].every(Number.isFinite)).toBe(true);
    const end = scenario.expected.at(-1);
    // Nothing stops on 44° of slope.
    if ((end === 'ship.landed' || end === 'ship.tipped') && scenario.name !== 'too-steep')
      expect(Math.hypot(...velocity), 'at rest').toBeLessThan(0.02);
  });
});

describe('the opening', () => {
  const run = valueOf(runScenario(named('opening')));

  it('touches within 2 s at about 12 m/s, bounces once, and is landed within 15 s', () => {
    const [first, second, landed] = times(run);
    expect(first).toBeLessThan(2);
    expect(second! - first!).toBeGreaterThan(3);
    // A 1 Hz server needs a second and a half to report it over a slow network.
    expect(landed).toBeLessThan(13.5);
    const shortly = valueOf(runScenario({ ...named('opening'), tickRate: 100, duration: first! }));
    const touch = readShip(shortly.ships, shortly.ships.length - SHIP_STRIDE, shortly.world);
    expect(touch.surfaceContactState).toBe('contact');
    expect(touch.contactImpactSpeed).toBeGreaterThan(11.5);
    expect(touch.contactImpactSpeed).toBeLessThan(12.5);
  });

  it('slides where it touches the second time', () => {
    const [, second, landed] = times(run);
    const [from, to] = [seenAt(run, Math.ceil(second!)), seenAt(run, Math.ceil(landed!))];
    expect(Math.hypot(to.position[0] - from.position[0], to.position[1] - from.position[1])).toBeGreaterThan(
      2,
    );
  });
});

describe('a slide', () => {
  it('covers the distance that friction allows', () => {
    const run = valueOf(runScenario(named('slide')));
    const gravity = (6.6743e-11 * 7.342e22) / 1737404.56 ** 2;
    // From the first whole second after the touch, once the legs have settled.
    const from = seenAt(run, 3);
    const to = seenAt(run, run.ships.length / SHIP_STRIDE - 1);
    const speed = Math.hypot(from.velocity[0], from.velocity[1]);
    const length = Math.hypot(to.position[0] - from.position[0], to.position[1] - from.position[1]);
    // It lands below 0.5 m/s and stops at once: 0.5²/(2 μ g) short of the full length.
    const expected = (speed ** 2 - 0.5 ** 2) / (2 * 0.5 * gravity);
    // Semi-implicit Euler moves with the new speed: half a substep's loss short, 5 cm here.
    const short = ((speed - 0.5) * run.loaded.timing.dt) / 2;
    expect(Math.abs(length - (expected - short))).toBeLessThan(0.01);
  });
});

describe('loading a scenario', () => {
  it.each([
    ['body', { body: 'Pluto' }],
    ['shipClass', { shipClass: 'brick' }],
    ['terrain', { terrain: '__proto__' }],
    ['tickRate', { tickRate: 0 }],
    ['inputs[0].thrustLevel', { inputs: [{ at: 0, controls: { thrustLevel: Number.NaN } }] }],
    [
      'inputs[1].at',
      {
        inputs: [
          { at: 2, controls: {} },
          { at: 1, controls: {} },
        ],
      },
    ],
    ['inputs[0].at', { inputs: [{ at: -1, controls: {} }] }],
  ] as [string, Partial<Scenario>][])('refuses %s by name', (field, change) => {
    const loaded = loadScenario({ ...named('settle'), ...change });
    expect(loaded.ok ? '' : loaded.reason).toContain(`${field}:`);
  });

  it('puts inputs onto the nearest substep at any tick rate', () => {
    const at = (tickRate: number) => {
      const { tick, substep } = valueOf(loadScenario({ ...named('right-itself'), tickRate })).inputs[1]!;
      return [tick, substep];
    };
    expect(at(1)).toEqual([10, 10]);
    expect(at(20)).toEqual([202, 0]);
    expect(at(100)).toEqual([1010, 0]);
  });

  it('gives the pilot’s controls at any time', () => {
    const loaded = valueOf(loadScenario(named('launch')));
    expect(pilotAt(loaded, 1.99).thrustLevel).toBe(0);
    expect(pilotAt(loaded, 2)).toMatchObject({ thrustLevel: 0.3, attitudeHold: true });
    expect(pilotAt(loaded, 100)).toMatchObject({ thrustLevel: 0, attitudeHold: true });
  });
});

describe('a fleet', () => {
  it('is placed around the site, ships apart from each other, the same for the same seed', () => {
    const loaded = valueOf(loadScenario(named('opening')));
    const orders = fleetOrders(loaded, 200, 5);
    expect(orders).toEqual(fleetOrders(loaded, 200, 5));
    expect(orders).not.toEqual(fleetOrders(loaded, 200, 6));
    const places = [loaded.ship, ...orders.map(({ ship }) => ship)].map((ship) => ship.relativePosition);
    let nearest = Infinity;
    for (const [i, a] of places.entries())
      for (const b of places.slice(0, i))
        nearest = Math.min(nearest, Math.hypot(...a.map((value, k) => value - b[k]!)));
    // 40 m along the meridian; along the parallel it is cos 20° of that.
    expect(nearest).toBeGreaterThan(35);
    expect(new Set(orders.map(({ shipId }) => shipId)).size).toBe(200);
  });

  it('flies sideways by three tenths of the first ship’s speed, and 1 m/s, more or less', () => {
    const given = named('opening');
    const loaded = valueOf(
      loadScenario({ ...given, initial: { ...given.initial, velocity: [20, 0, -6], height: 100 } }),
    );
    const still = valueOf(
      loadScenario({ ...given, initial: { ...given.initial, velocity: [0, 0, -6], height: 100 } }),
    ).ship.relativeVelocity;
    const eastward = loaded.ship.relativeVelocity.map((value, k) => (value - still[k]!) / 20);
    const speeds = fleetOrders(loaded, 1000, 5).map(({ ship }) =>
      ship.relativeVelocity.reduce((sum, value, k) => sum + (value - still[k]!) * eastward[k]!, 0),
    );
    const mean = speeds.reduce((sum, value) => sum + value, 0) / speeds.length;
    const spread = Math.sqrt(speeds.reduce((sum, value) => sum + (value - mean) ** 2, 0) / speeds.length);
    expect(mean).toBeCloseTo(20, 0);
    expect(spread).toBeCloseTo(Math.hypot(0.3 * 20, 1), 0);
  });
});

const input = (tick: number, substep: number, thrustLevel: number): ScheduledInput => ({
  tick,
  substep,
  controls: { ...NEUTRAL_CONTROLS, thrustLevel },
});

describe('scheduled inputs', () => {
  it('act once each, at their own substep', () => {
    const schedule = scheduleOf([input(0, 1, 0.1), input(1, 0, 0.2)]);
    const seen = [0, 1].flatMap((tick) => [0, 1, 2].map((s) => schedule(tick, s)?.thrustLevel ?? null));
    expect(seen).toEqual([null, 0.1, null, 0.2, null, null]);
  });

  it('of one substep, or of those before the first, leave the last of them in force', () => {
    const schedule = scheduleOf([input(0, 0, 0.1), input(0, 2, 0.2), input(3, 1, 0.3), input(3, 1, 0.4)]);
    expect(schedule(1, 0)?.thrustLevel).toBe(0.2);
    expect(schedule(3, 1)?.thrustLevel).toBe(0.4);
    expect(schedule(3, 2)).toBeNull();
  });
});
