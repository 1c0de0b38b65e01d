import { describe, expect, it } from 'vitest';
import { type Controls, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import {
  createLandingReadout,
  type HintAction,
  updateLandingReadout,
  type LandingReadout,
  ROTATION_ACTIONS,
  TRANSLATION_ACTIONS,
} from '../../../src/readout';
import { runLaw } from '../law';
import { makeView, type Pose } from '../views';

const MOON_GRAVITY = (6.6743e-11 * 7.342e22) / (1737400 + 4.56) ** 2;
const MARS_GRAVITY = (6.6743e-11 * 6.4171e23) / (3389500 + 4.56) ** 2;
const ON_SIDE: Pose = { state: 'tipped', clearance: -0.016, tilt: 89.6, fuel: 4000 };

/** The readout once its run ahead is done. */
function read(pose: Pose): LandingReadout {
  const out = createLandingReadout();
  const view = makeView(pose);
  for (let i = 0; i < 60; i++) updateLandingReadout(out, view);
  return out;
}

/** rotation_input of an action, from the table that names them. */
function inputOf(actions: readonly HintAction[]): [number, number, number] {
  const input: [number, number, number] = [0, 0, 0];
  ROTATION_ACTIONS.forEach(([plus, minus], axis) => {
    if (actions.includes(plus)) input[axis] = 1;
    if (actions.includes(minus)) input[axis] = -1;
  });
  return input;
}

describe('righting help', () => {
  it('is shown while tipped', () => {
    expect(read(ON_SIDE).righting.shown).toBe(true);
    for (const state of ['', 'contact', 'landed'] as const) {
      expect(read({ ...ON_SIDE, state, tilt: 0 }).righting.shown).toBe(false);
    }
  });

  it('stays while its keys bring the ship up, shows when to let go, and then gives way to the gates', () => {
    const out = read(ON_SIDE);
    const { actions, holdUntil } = out.righting;
    const show = (
      tilt: number,
      rotationInput: [number, number, number],
      state: 'contact' | '' = 'contact',
      tiltRate = -1,
    ) =>
      updateLandingReadout(
        out,
        makeView({ ...ON_SIDE, state, tilt, tiltRate }, { controls: { ...NEUTRAL_CONTROLS, rotationInput } }),
      );
    const held = inputOf(actions);
    expect(show(holdUntil + 1, held).righting).toMatchObject({ shown: true, release: false, actions });
    expect(out.righting.holdUntil).toBeCloseTo(holdUntil, 9);
    expect([out.gates.shown, out.margin.shown]).toEqual([false, false]);
    expect(show(holdUntil - 1, held).righting).toMatchObject({ shown: true, release: true });
    expect(show(holdUntil + 1, held, 'contact', 0.5).righting).toMatchObject({ shown: true, release: true });
    expect(show(20, [0, 0, 0]).righting.shown).toBe(false);
    expect(out.gates.shown).toBe(true);
    // Not of another fall: what was found out holds for this one.
    show(20, held, '');
    expect(show(20, held).righting.shown).toBe(false);
  });

  it('names an angle that allows for reaction time: released at once or a third of a second late, the ship lands', () => {
    for (let heading = 0; heading < 360; heading += 45) {
      const pose = { ...ON_SIDE, heading };
      const { righting } = read(pose);
      for (const late of [0, 0.33]) {
        const run = runLaw(pose);
        run.command({ ...NEUTRAL_CONTROLS, rotationInput: inputOf(righting.actions) });
        while (run.cosTilt() < Math.cos((righting.holdUntil * Math.PI) / 180)) run.step();
        const seen = run.seconds();
        while (run.seconds() < seen + late) run.step();
        run.command({ ...NEUTRAL_CONTROLS, attitudeHold: true });
        let event = '';
        while (event !== 'ship.landed' && run.seconds() < 60) event = run.step();
        expect([heading, late, event]).toEqual([heading, late, 'ship.landed']);
      }
    }
  });

  it('gives the available and the needed torque: weight · h', () => {
    const { righting } = read({ ...ON_SIDE, leanTo: 0, heading: 0 });
    expect(righting.torqueNeeded).toBeCloseTo(12_000 * MOON_GRAVITY * 4.56, -1);
    expect(righting.possible).toBe(true);
    const dry = read({ ...ON_SIDE, fuel: 0 }).righting;
    // Wheels alone: 2 kN m about x and y each, √2 of one at most.
    expect(dry.torqueAvailable).toBeGreaterThanOrEqual(2000 * 0.92);
    expect(dry.torqueAvailable).toBeLessThanOrEqual(2000 * Math.SQRT2);
    expect(dry.possible).toBe(false);
    // Its wheels are as strong about x as about y: a quarter turn changes nothing.
    const wheelsAt = (heading: number) => read({ ...ON_SIDE, fuel: 0, heading }).righting.torqueAvailable;
    for (let heading = 0; heading < 90; heading += 15)
      expect(wheelsAt(heading + 90)).toBeCloseTo(wheelsAt(heading), 3);
    const { torqueAvailable } = read({ ...ON_SIDE, fuel: 0.5 }).righting;
    expect(torqueAvailable).toBe(righting.torqueAvailable);
  });

  it('names keys that right the ship, whichever side it is on', () => {
    const seen = new Set<string>();
    for (let heading = 0; heading < 360; heading += 30) {
      const pose = { ...ON_SIDE, heading };
      const { righting } = read(pose);
      expect(righting).toMatchObject({ possible: true, outcome: 'lands', help: 'none' });
      for (const action of righting.actions) seen.add(action);
      const run = runLaw(pose);
      run.command({ ...NEUTRAL_CONTROLS, rotationInput: inputOf(righting.actions) });
      while (run.cosTilt() < Math.cos((righting.holdUntil * Math.PI) / 180)) run.step();
      expect(run.seconds()).toBeCloseTo(righting.holdSeconds, 6);
      run.command({ ...NEUTRAL_CONTROLS, attitudeHold: true });
      let event = '';
      while (event !== 'ship.landed' && run.seconds() < 60) event = run.step();
      expect(event).toBe('ship.landed');
      expect(4000 - run.fuel()).toBeCloseTo(righting.fuelNeeded, 6);
    }
    expect([...seen].sort()).toEqual(['pitchMinus', 'pitchPlus', 'yawMinus', 'yawPlus']);
  });

  it('names one key along an axis and two between them', () => {
    const counts = new Set<number>();
    for (let heading = 0; heading < 360; heading += 15) {
      counts.add(read({ ...ON_SIDE, heading }).righting.actions.length);
    }
    expect([...counts].sort()).toEqual([1, 2]);
  });

  it('reports that no control can right the lander on Earth', () => {
    const { righting } = read({ ...ON_SIDE, body: 'Earth' });
    expect(righting).toMatchObject({ possible: false, help: 'none', helpAction: '' });
    expect(righting.torqueNeeded / righting.torqueAvailable).toBeGreaterThan(3);
  });

  it('gives the mass below which it can be righted, where burning fuel gets there', () => {
    const { righting } = read({ ...ON_SIDE, body: 'Mars', fuel: 4000 });
    expect(righting).toMatchObject({ possible: false, help: 'lighter', helpAction: '' });
    expect(righting.helpMass).toBeCloseTo(righting.torqueAvailable / (MARS_GRAVITY * 4.56), -1);
    const enough = { ...ON_SIDE, body: 'Mars', fuel: righting.helpMass - 8000 - 20 } as const;
    expect(read(enough).righting.possible).toBe(true);
    expect(read({ ...enough, fuel: enough.fuel + 40 }).righting.possible).toBe(false);
  });

  it('names the thruster that unloads its feet, and the law agrees', () => {
    const pose: Pose = { ...ON_SIDE, body: 'Mars', fuel: 600 };
    const { righting } = read(pose);
    expect(righting).toMatchObject({ possible: false, help: 'translation' });
    const axis = TRANSLATION_ACTIONS.findIndex((pair) =>
      pair.some((action) => action === righting.helpAction),
    );
    const translationInput: [number, number, number] = [0, 0, 0];
    translationInput[axis] = TRANSLATION_ACTIONS[axis]![0] === righting.helpAction ? 1 : -1;
    const rotationInput = inputOf(righting.actions);
    const rights = (controls: Controls): boolean => {
      const run = runLaw(pose);
      run.command(controls);
      while (run.seconds() < 20) if (run.step() === 'ship.righted') return true;
      return false;
    };
    expect(rights({ ...NEUTRAL_CONTROLS, rotationInput })).toBe(false);
    expect(rights({ ...NEUTRAL_CONTROLS, rotationInput, translationInput })).toBe(true);
  });

  it('spends at most 200 substeps a view', () => {
    const out = createLandingReadout();
    const view = makeView(ON_SIDE);
    const { run } = out.memory.ahead!.righting;
    // To the point of no return, in less.
    updateLandingReadout(out, view);
    expect(run).toMatchObject({ outcome: 'working', projection: { running: false } });
    updateLandingReadout(out, view);
    // Substeps of 0.01 s.
    expect(run.projection.elapsed).toBeCloseTo(2, 9);
    expect(out.righting.outcome).toBe('working');
    for (let i = 0; i < 3; i++) updateLandingReadout(out, view);
    expect(out.righting.outcome).toBe('lands');
  });

  it('spends no substep once it has its answer', () => {
    const out = createLandingReadout();
    const view = makeView(ON_SIDE);
    for (let i = 0; i < 60; i++) updateLandingReadout(out, view);
    const done = out.memory.ahead!.righting.run.projection.elapsed;
    expect(done).toBeGreaterThan(0);
    for (let i = 0; i < 60; i++) {
      updateLandingReadout(out, view);
      expect(out.memory.ahead!.righting.run.projection).toMatchObject({ elapsed: done, running: false });
    }
  });

  it.each([
    ['fuel', { fuel: 3990.1 }, { fuel: 3990 }],
    ['tilt', { tilt: 91.6 }, { tilt: 91.7 }],
  ] as const)('keeps its answer until the %s differs by 10 kg or 2°', (_, near, far) => {
    const out = createLandingReadout();
    const show = (pose: Pose) => {
      const view = makeView(pose);
      for (let i = 0; i < 60; i++) updateLandingReadout(out, view);
      return out.righting.holdSeconds;
    };
    const first = show(ON_SIDE);
    expect(show({ ...ON_SIDE, ...near })).toBe(first);
    const other = { fuel: 4000, tilt: 89.6, ...far };
    expect(show({ ...ON_SIDE, ...other })).toBe(read({ ...ON_SIDE, ...other }).righting.holdSeconds);
    const { startFuel, startTilt } = out.memory.ahead!.righting.run;
    expect([startFuel, (startTilt * 180) / Math.PI]).toEqual([other.fuel, expect.closeTo(other.tilt, 9)]);
  });
});
