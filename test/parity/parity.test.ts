import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { agrees, compareFixture, readFixture, TOLERANCES } from '../../src/scenarios';
import { valueOf } from '../authority/moon';
import { parityLine } from './parityLine';

const FOLDER = join(import.meta.dirname, 'fixtures');
const FILES = readdirSync(FOLDER).filter((name) => name.endsWith('.json'));

type Json = Record<string, unknown>;
const text = (name: string) => readFileSync(join(FOLDER, name), 'utf8');
const json = (name: string) =>
  JSON.parse(text(name)) as Json & Record<'states' | 'events' | 'inputs', Json[]>;

/** A fixture with one thing changed. */
function spoilt(name: string, spoil: (file: ReturnType<typeof json>) => void): string {
  const file = json(name);
  spoil(file);
  return JSON.stringify(file);
}

describe('parity', () => {
  it('has trajectories to compare with', () => {
    expect(FILES.length).toBe(45);
  });

  it.each(FILES)('%s: states and events to the tick, values within tolerance', (name) => {
    const comparison = valueOf(compareFixture(valueOf(readFixture(text(name)))));
    expect(comparison.disagreement).toBeNull();
    expect(comparison.outOfTolerance).toBeNull();
    expect(comparison.statesCompared).toBe(json(name).states.length);
    // Today's worst, of all files: 1e-8 m, 1.6e-9 m/s, 1.8e-8 of attitude, of a ship that topples over its footprint's edge on curved
    // terrain; on level ground below 1e-13. A fourth of the tolerance is slack.
    for (const [field, worst] of Object.entries(comparison.worst))
      expect(worst, field).toBeLessThan(TOLERANCES[field as keyof typeof TOLERANCES] / 4);
  });

  it.each([
    ['position', 'relative_position', 0, 2e-5],
    ['velocity', 'relative_velocity', 1, 2e-5],
    ['attitude', 'attitude', 2, 2e-7],
    ['spin', 'angular_velocity', 0, 2e-7],
  ])('detects a %s that is off by twice its tolerance', (_what, field, k, off) => {
    const file = spoilt('topple.json', ({ states }) => {
      (states[20]![field] as number[])[k]! += off;
    });
    const comparison = valueOf(compareFixture(valueOf(readFixture(file))));
    expect(comparison.outOfTolerance?.tick).toBe(json('topple.json').states[20]!['tick']);
    expect(agrees(comparison)).toBe(false);
  });

  it.each([
    ['fuel', 'fuel', 2e-6],
    ['impact speed', 'impact_speed', 2e-5],
  ])('detects a %s that is off by twice its tolerance', (_what, field, off) => {
    const file = spoilt('launch.json', ({ states }) => {
      states[3]![field] = (states[3]![field] as number) + off;
    });
    expect(valueOf(compareFixture(valueOf(readFixture(file)))).outOfTolerance).not.toBeNull();
  });

  it('accepts an attitude with its sign reversed', () => {
    const file = spoilt('topple.json', ({ states }) => {
      states[20]!['attitude'] = (states[20]!['attitude'] as number[]).map((value) => -value);
    });
    expect(agrees(valueOf(compareFixture(valueOf(readFixture(file)))))).toBe(true);
  });

  it('names the first tick that differs in state or event', () => {
    const state = spoilt('settle-moon.json', ({ states }) => {
      states[7]!['surface_contact_state'] = 'contact';
    });
    expect(valueOf(compareFixture(valueOf(readFixture(state)))).disagreement).toEqual({
      tick: json('settle-moon.json').states[7]!['tick'],
      how: "state 'landed', expected 'contact'",
    });
    const later = spoilt('settle-moon.json', ({ events }) => {
      events[1]!['tick'] = 18;
    });
    expect(valueOf(compareFixture(valueOf(readFixture(later)))).disagreement).toEqual({
      tick: 17,
      how: 'ship.landed at tick 17, expected ship.landed at tick 18',
    });
    const missing = spoilt('settle-moon.json', ({ events }) => events.pop());
    expect(valueOf(compareFixture(valueOf(readFixture(missing)))).disagreement?.how).toContain(
      'expected no event',
    );
    const extra = spoilt('settle-moon.json', ({ events }) =>
      events.push({ tick: 230, event: 'ship.contact' }),
    );
    expect(valueOf(compareFixture(valueOf(readFixture(extra)))).disagreement?.tick).toBe(230);
  });

  it('detects a law with other settings', () => {
    const file = spoilt('slide-origin.json', (fixture) => {
      fixture['config'] = { contact_friction_kinetic: 0.5001 };
    });
    const comparison = valueOf(compareFixture(valueOf(readFixture(file))));
    expect(comparison.outOfTolerance).not.toBeNull();
  });

  it('prints one line per file: differences, or the invalid field', () => {
    const good = parityLine('topple.json', text('topple.json'));
    expect(good.passed).toBe(true);
    expect(good.line).toMatch(/^topple\.json +position .* m {2}velocity .* m\/s.*states and events agree/);
    const bad = parityLine(
      'bad.json',
      spoilt('topple.json', (file) => (file['tick_seconds'] = '0.05')),
    );
    expect(bad).toEqual({
      passed: false,
      line: "bad.json: tick_seconds: expected a finite number, got '0.05'",
    });
  });
});

describe('a malformed fixture is refused by its field', () => {
  const cases: [string, (file: ReturnType<typeof json>) => void][] = [
    ['terrain.axis', (f) => (f['terrain'] = { base: 0, amplitude: 1, axis: [0, 1] })],
    ['terrain.name', (f) => (f['terrain'] = { name: 'constructor' })],
    ['config.contact_crash', (f) => (f['config'] = { contact_crash: 50 })],
    ['config.contact_crash_speed', (f) => (f['config'] = { contact_crash_speed: '50' })],
    ['config.contact_bounce_speed', (f) => (f['config'] = { contact_bounce_speed: 60 })],
    ['config.touchdown_attitude', (f) => (f['config'] = { touchdown_attitude: 'upright' })],
    ['ship_class.dry_mass', (f) => ((f['ship_class'] as Json)['dry_mass'] = null)],
    ['ship class lander: dry_mass', (f) => ((f['ship_class'] as Json)['dry_mass'] = 0)],
    ['ship_class.inertia_tensor', (f) => ((f['ship_class'] as Json)['inertia_tensor'] = [[1, 0, 0]])],
    [
      'ship class lander: inertia_tensor[2][2]',
      (f) =>
        ((f['ship_class'] as Json)['inertia_tensor'] = [
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, -1],
        ]),
    ],
    ['body.radius', (f) => delete (f['body'] as Json)['radius']],
    ['body Moon: radius', (f) => ((f['body'] as Json)['radius'] = 0)],
    ['body.attitude', (f) => ((f['body'] as Json)['attitude'] = [0, 0, 0, 2])],
    [
      'initial.relative_position[1]',
      (f) => (((f['initial'] as Json)['relative_position'] as unknown[])[1] = 'x'),
    ],
    ['initial.relative_position', (f) => ((f['initial'] as Json)['relative_position'] = [0, 0, 0])],
    ['initial.fuel', (f) => ((f['initial'] as Json)['fuel'] = -1)],
    ['initial.landed_body_name', (f) => ((f['initial'] as Json)['landed_body_name'] = 'Sun')],
    ['inputs[0].thrust', (f) => (f.inputs = [{ tick: 0, thrust: 1 }])],
    ['inputs[0].rotation_input[2]', (f) => (f.inputs = [{ tick: 0, rotation_input: [0, 0, null] }])],
    ['inputs[0].attitude_mode', (f) => (f.inputs = [{ tick: 0, attitude_mode: 7 }])],
    ['inputs[0].target_attitude', (f) => (f.inputs = [{ tick: 0, target_attitude: [0, 0, 0, 0] }])],
    ['inputs[0].substep', (f) => (f.inputs = [{ tick: 0, substep: 5 }])],
    ['inputs[1].tick', (f) => (f.inputs = [{ tick: 9 }, { tick: 8 }])],
    ['states[3].surface_contact_state', (f) => (f.states[3]!['surface_contact_state'] = 'sunk')],
    ['states[3].crashed', (f) => (f.states[3]!['crashed'] = 0)],
    ['states[4].tick', (f) => (f.states[4]!['tick'] = f.states[3]!['tick'])],
    ['states[0].attitude', (f) => (f.states[0]!['attitude'] = [0, 0, 0, 0])],
    ['states', (f) => (f.states = [])],
    ['states', (f) => (f.states.at(-1)!['tick'] = 1e15)],
    ['events[0].event', (f) => (f.events[0]!['event'] = 'ship.sank')],
    ['events[0].tick', (f) => (f.events[0]!['tick'] = 0)],
    ['tick_seconds', (f) => (f['tick_seconds'] = 1e9)],
    ['substeps_per_tick', (f) => (f['substeps_per_tick'] = 6)],
    ['inputs', (f) => (f.inputs = {} as Json[])],
  ];

  it.each(cases)('%s', (field, spoil) => {
    const { line, passed } = parityLine('bad.json', spoilt('topple.json', spoil));
    expect(passed).toBe(false);
    expect(line.startsWith(`bad.json: ${field}: `)).toBe(true);
  });

  it('with numbers beyond doubles, lists beyond counts, or text that is not JSON', () => {
    const infinite = text('topple.json').replace('"mass":7.342e+22', '"mass":7.342e+999');
    expect(parityLine('f', infinite).line).toContain('body.mass: expected a finite number, got Infinity');
    const many = spoilt('topple.json', (f) => (f.events = Array.from({ length: 100_001 }, () => ({}))));
    expect(parityLine('f', many).line).toContain('events: expected at most 100000 items');
    for (const garbage of ['', 'nul', '[]', 'null', '3', '{"a":']) {
      const { line, passed } = parityLine('f', garbage);
      expect(passed).toBe(false);
      expect(line).toMatch(/^f: (not JSON|file): /);
    }
  });
});
