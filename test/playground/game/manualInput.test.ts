/** The pilot's input against a plan and the autopilot. */
import { Quaternion, Vector3 } from 'three';
import { describe, expect, it, vi } from 'vitest';
import { flatTerrain } from '../../../src/dynamics';
import { createFlightControls } from '../../../src/playground/game/flight/flightControls';
import { createLandingReadout, updateLandingReadout } from '../../../src/readout';
import { makeView } from '../../readout/views';
import { open, useGameClock } from './openGame';

useGameClock();

/** Turn and push of each key, in the ship's own axes and as seen by an eye that looks along its x. */
const KEYS = new Map([
  ['pitchPlus', ['1 0 0 0 0 0', '0 -1 0 0 0 0']],
  ['yawPlus', ['0 1 0 0 0 0', '-1 0 0 0 0 0']],
  ['rollPlus', ['0 0 1 0 0 0', '0 0 1 0 0 0']],
  ['translateXPlus', ['0 0 0 1 0 0', '0 0 0 0 -1 0']],
  ['translateYPlus', ['0 0 0 0 1 0', '0 0 0 1 0 0']],
  ['translateZPlus', ['0 0 0 0 0 1', '0 0 0 0 0 1']],
] as const);

describe('the autopilot', () => {
  it('lands softly from the mission’s start, and is switched off by the key that switched it on', () => {
    const { live, play } = open({ scenario: 'first-landing', network: 'broadband' });
    play(30, 1);
    live.flightControls.press('autopilot');
    play(30, 2);
    expect(live.view().own!.controls.attitudeMode).toBe('radial');
    live.flightControls.press('autopilot');
    expect(live.flightControls.autopilot.isOn()).toBe(false);
    const held = live.view().own!.controls.thrustLevel;
    play(30, 0.5);
    expect(live.view().own!.controls).toMatchObject({ attitudeMode: 'none', attitudeHold: true });
    expect(live.view().own!.controls.thrustLevel).toBeCloseTo(held, 1);
    live.flightControls.press('autopilot');
    play(30, 60);
    const { own } = live.frame();
    expect(own!.shownState).toBe('landed');
    expect(own!.touchdown.verticalSpeed).toBeLessThan(2);
  });

  it.each([0.4, 1])('lands as softly on a display that draws %s pictures per second', (fps) => {
    const { live, play } = open({ scenario: 'first-landing', network: 'broadband' });
    play(fps, 4);
    live.flightControls.press('autopilot');
    play(fps, 60);
    const { own } = live.frame();
    expect(own!.shownState).toBe('landed');
    expect(own!.impactSpeed).toBeLessThan(2);
    expect(live.flightControls.autopilot.reason()).toBe('');
  });

  it.each([0.4, 10])('brakes a fast approach before it descends, at %s pictures per second', (fps) => {
    const { live, play } = open({ scenario: 'long-approach', network: 'broadband' });
    play(fps, 4);
    live.flightControls.press('autopilot');
    let speed = NaN;
    const readout = createLandingReadout();
    play(fps, 130, (view) => {
      if (view.own!.shownState === '') speed = updateLandingReadout(readout, view).descent.horizontalSpeed;
    });
    const { own } = live.frame();
    expect(own!.shownState).toBe('landed');
    expect(speed).toBeLessThan(0.5);
    expect(own!.impactSpeed).toBeLessThan(2);
  });

  it('disengages after a touch that is hard enough to bounce, and names its speed', () => {
    const { live, play } = open({ scenario: 'bounce', network: 'broadband' });
    // 20 m up at 24 m/s: too late to brake.
    play(60, 0.5);
    live.flightControls.press('autopilot');
    play(60, 2);
    expect(live.flightControls.autopilot.isOn()).toBe(false);
    expect(live.flightControls.autopilot.reason()).toMatch(/^hit the Moon at 2\d\.\d m\/s$/);
    // Not at the thrust that braked.
    expect(live.view().own!.controls.thrustLevel).toBe(0);
  });
});

describe('manual input', () => {
  it('turns the ship only while a key is held: a mission begins with rate damping on', () => {
    const { live, play } = open({ scenario: 'first-landing', network: 'broadband' });
    const rate = () => Math.hypot(...live.view().own!.angularVelocity);
    play(30, 1);
    live.flightControls.press('yawMinus');
    live.steer();
    play(30, 0.5);
    expect(rate()).toBeGreaterThan(0.1);
    live.flightControls.release('yawMinus');
    live.steer();
    play(30, 5);
    expect(rate()).toBeLessThan(0.001);
  });

  it('is put back with a snapshot: lever, damping and mode, or the autopilot that flew', () => {
    const { live, play } = open({ scenario: 'first-landing', network: 'broadband' });
    const { flightControls } = live;
    play(30, 1);
    const untouched = flightControls.save();
    const first = live.view().own!.controls.thrustLevel;
    flightControls.press('modeUpright');
    flightControls.setThrottle(0.25);
    play(30, 1);
    const saved = flightControls.save();
    flightControls.press('modeUpright');
    flightControls.press('rateDamping');
    flightControls.press('throttleFull');
    play(30, 1);
    flightControls.restore(saved);
    play(30, 1);
    const own = () => live.view().own!.controls;
    expect(own()).toMatchObject({ thrustLevel: 0.25, attitudeMode: 'radial', attitudeHold: true });
    flightControls.restore(untouched);
    play(30, 1);
    expect(own()).toMatchObject({ attitudeMode: 'none', attitudeHold: true });
    // Up to the lever's step.
    expect(own().thrustLevel).toBeCloseTo(first, 2);
    flightControls.press('autopilot');
    play(30, 1);
    const flown = flightControls.save();
    flightControls.restore(saved);
    expect(flightControls.autopilot.isOn()).toBe(false);
    flightControls.restore(flown);
    play(30, 60);
    expect(live.view().own!).toMatchObject({ shownState: 'landed' });
  });

  it('ends the plan at its first use, with any control, and nothing overrides it', () => {
    const { live, play } = open({ scenario: 'freighter-hold', network: 'lan' });
    play(60, 1);
    expect(live.view().own!.controls).toMatchObject({ thrustLevel: 0.5, attitudeMode: 'radial' });
    // The plan would turn the ship from 2.6 s on; the pilot only cuts the engine.
    play(60, 0.5);
    live.flightControls.press('throttleCut');
    const turned = new Set<number>();
    play(60, 6, (view) => turned.add(view.own!.controls.rotationInput[0]));
    expect([...turned]).toEqual([0]);
    expect(live.view().own!.controls).toMatchObject({ thrustLevel: 0, attitudeMode: 'radial' });
    const { diagnosis } = live.frame();
    expect(diagnosis).toMatchObject({
      correctionsMismatch: 0,
      correctionsOtherPilot: 0,
      correctionsLateInput: 0,
    });
  });

  it('that arrives late lets the plan run until it arrives, and no longer', () => {
    const { live, play } = open({ scenario: 'freighter-hold', network: 'lan' });
    play(60, 1);
    live.operate({ kind: 'drop' });
    live.flightControls.press('throttleCut');
    // Meanwhile the server continues the plan: engine, and the turn from 2.6 s to 3.6 s.
    play(60, 1.8);
    expect(live.view().own!.controls).toMatchObject({ thrustLevel: 0, rotationInput: [0, 0, 0] });
    live.reconnect();
    play(60, 4);
    const { diagnosis, own } = live.frame();
    expect(diagnosis.correctionsLateInput).toBeGreaterThan(0);
    expect(diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsOtherPilot: 0 });
    expect(own).toMatchObject({ provenance: 'confirmed' });
    expect(own!.controls).toMatchObject({ thrustLevel: 0, rotationInput: [0, 0, 0], attitudeMode: 'radial' });
  });

  it('taps for as long as the key was down, however far apart the frames are', () => {
    const { live, play, entries } = open({ scenario: 'opening', network: 'lan' });
    play(2, 3);
    for (const hand of ['press', 'release'] as const) {
      vi.advanceTimersByTime(60);
      live.flightControls[hand]('pitchPlus');
      live.steer();
    }
    play(2, 2);
    const turns = entries.flatMap((entry) =>
      entry.kind === 'sent' && entry.message.kind === 'inputs' ? entry.message.inputs : [],
    );
    const [held, released] = turns.map(({ controls }) => controls.rotationInput);
    expect(turns).toHaveLength(2);
    expect(held![0]).toBeGreaterThan(0.3);
    expect(released).toEqual([0, 0, 0]);
    // 60 ms of 10 ms each.
    const [down, up] = turns.map(({ tick, substep }) => tick * 100 + substep);
    expect(up! - down!).toBeGreaterThanOrEqual(5);
    expect(up! - down!).toBeLessThanOrEqual(7);
    const { diagnosis } = live.frame();
    expect(diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsLateInput: 0 });
  });

  it('takes over also without a change of controls', () => {
    const { live, play } = open({ scenario: 'launch', network: 'lan' });
    play(60, 1);
    live.flightControls.press('throttleCut');
    play(60, 8, (view) => expect(view.own!.surfaceContactState).toBe('landed'));
    expect(live.frame().diagnosis).toMatchObject({ correctionsMismatch: 0, correctionsOtherPilot: 0 });
  });
});

it('keys turn about and push along the screen’s axes, where there is one, and the ship’s own otherwise', () => {
  const view = makeView({ clearance: 50, heading: 30 });
  const inShip = (x: number, y: number, z: number) =>
    new Vector3(x, y, z).applyQuaternion(new Quaternion(...view.own.attitude)).toArray();
  const byKeys = (screen: Float64Array | null) => {
    const controls = createFlightControls(
      () => view,
      () => flatTerrain,
    );
    controls.steerInScreenAxes(() => screen);
    const signs = ([...KEYS.keys()] as const).map((action) => {
      controls.press(action);
      const { rotationInput, translationInput } = controls.sample(view, 0, 0.02)!;
      controls.release(action);
      return [...rotationInput, ...translationInput].map((x) => Math.sign(Math.round(100 * x)) + 0).join(' ');
    });
    return signs;
  };
  expect(byKeys(null)).toEqual([...KEYS.values()].map(([own]) => own));
  // The eye looks along the ship's x: what is right on the screen is −y.
  const screen = Float64Array.of(...inShip(0, -1, 0), ...inShip(1, 0, 0), ...inShip(0, 0, 1));
  expect(byKeys(screen)).toEqual([...KEYS.values()].map(([, seen]) => seen));
});

it('a stick follows the screen as it turns; a held key keeps the axes that it went down in', () => {
  const view = makeView({ clearance: 50 });
  const ahead = Float64Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
  const aside = Float64Array.of(0, 1, 0, -1, 0, 0, 0, 0, 1);
  const controls = createFlightControls(
    () => view,
    () => flatTerrain,
  );
  const turnOn = (screen: Float64Array) => {
    controls.steerInScreenAxes(() => screen);
    return controls.sample(view, 0, 0.02)!.rotationInput;
  };
  controls.takeOver();
  Object.assign(controls.stick.deflection, { tiltAway: 1 });
  expect(turnOn(ahead)).not.toEqual(turnOn(aside));
  Object.assign(controls.stick.deflection, { tiltAway: 0 });
  controls.steerInScreenAxes(() => ahead);
  controls.press('pitchPlus');
  expect(turnOn(aside)).toEqual(turnOn(ahead));
});
