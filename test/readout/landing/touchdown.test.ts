import { describe, expect, it } from 'vitest';
import { type Controls, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import type { ShipView, WorldView } from '../../../src/prediction';
import { NETWORK_PRESETS, loadScenario } from '../../../src/scenarios';
import type { ClientMessage } from '../../../src/wire';
import { createLandingReadout, updateLandingReadout, type LandingReadout } from '../../../src/readout';
import { createRig, type Rig, type RigOptions, SHIP, value } from '../../prediction/rig';
import { type Card, cardOf, follow, type Track } from './touchdownTruth';
import { makeView, NO_TOUCHDOWN, type Pose } from '../views';

interface Flight {
  readonly rig: Rig;
  readonly readout: LandingReadout;
  readonly truth: Card;
}

/** Flies a scenario to its end at `hz` frames per second, with a readout for each. */
function fly(
  options: RigOptions & { hz: number },
  each?: (rig: Rig, readout: LandingReadout) => void,
): Flight {
  const rig = createRig(options);
  const readout = createLandingReadout();
  const track: Track = { rows: [], dt: 0, tick: 0 };
  rig.fly(rig.loaded.scenario.duration, (view) => {
    updateLandingReadout(readout, view);
    follow(track, rig.truth);
    each?.(rig, readout);
  });
  expect(rig.truth.disagreements).toBe(0);
  return { rig, readout, truth: cardOf(track, rig.loaded.body) };
}

const RATES = [2, 7, 30, 144];

function expectCard({ touchdown }: LandingReadout, truth: Card): void {
  expect(touchdown.known).toBe(true);
  expect(touchdown.bounces).toBe(truth.bounces);
  // The law's own numbers, to the bit.
  expect(touchdown.verticalSpeed).toBe(truth.verticalSpeed);
  expect(touchdown.horizontalSpeed).toBeCloseTo(truth.horizontalSpeed, 8);
  expect(touchdown.settleSeconds).toBeCloseTo(truth.settleSeconds, 8);
  expect(touchdown.largestTilt).toBeCloseTo(truth.largestTilt, 5);
  // 1 cm: the distance of the last substep, whose speed the law removes as the ship comes to rest.
  expect(Math.abs(touchdown.slideMetres - truth.slideMetres)).toBeLessThan(0.01);
}

describe('the touchdown card', () => {
  for (const scenario of [
    'opening',
    'settle',
    'bounce',
    'slide',
    'topple',
    'up-a-slope',
    'over-the-edge',
    'bounce-earth',
    'slide-mars',
    'settle-phobos',
  ])
    it(`of ${scenario} matches the law at ${RATES.join(', ')} frames per second`, () => {
      for (const hz of RATES) {
        const { readout, truth } = fly({ scenario, hz });
        expect(readout.touchdownShown).toBe(true);
        expectCard(readout, truth);
      }
    });

  it('matches the law through late inputs and their corrections', () => {
    // Pushes in both directions all the way: a late input changes when, where and how fast it touches.
    const pilot = (game: number): Controls => {
      const push = game > 9 ? 0 : Math.floor(game * 3) % 2 === 1 ? 1 : -1;
      return { ...NEUTRAL_CONTROLS, translationInput: [push, push, push], attitudeHold: true };
    };
    const holdBack = (_: ClientMessage, now: number) => (Math.floor(now) % 2 === 0 ? now : now + 0.7);
    let corrected = 0;
    for (const hz of [7, 60])
      for (const seed of [1, 2, 3]) {
        const network = NETWORK_PRESETS.broken;
        const { rig, readout, truth } = fly({ scenario: 'opening', hz, seed, network, pilot, holdBack });
        corrected += rig.view().diagnosis.correctionsLateInput;
        expect(readout.touchdown.outcome).toBe('landed');
        expectCard(readout, truth);
      }
    expect(corrected).toBeGreaterThan(10);
  });

  it('matches the law when the page was hidden for the whole landing', () => {
    const rig = createRig({ scenario: 'bounce' });
    const track: Track = { rows: [], dt: 0, tick: 0 };
    rig.fly(0.5);
    while (rig.now < 27) {
      rig.receiveOnly();
      follow(track, rig.truth);
    }
    const readout = createLandingReadout();
    rig.fly(0.5, (view) => updateLandingReadout(readout, view));
    expect(readout.touchdownShown).toBe(true);
    expectCard(readout, cardOf(track, rig.loaded.body));
  });

  it('drops a predicted touch that was withdrawn', () => {
    const seen: number[] = [];
    let kicked = false;
    const { rig, readout, truth } = fly({ scenario: 'settle', hz: 60 }, ({ now, view, authority }, read) => {
      if (read.touchdown.known) seen.push(read.touchdown.verticalSpeed);
      if (kicked || now < 1.3) return;
      kicked = true;
      // An operator lifts the ship between two frames: it touches later and harder than predicted.
      const up = view().own!.serverPosition;
      const far = Math.hypot(...up);
      authority.kick(SHIP, [(3 * up[0]!) / far, (3 * up[1]!) / far, (3 * up[2]!) / far], [0, 0, 0]);
    });
    expect(rig.notices.filter(({ kind }) => kind === 'retracted').length).toBeGreaterThan(0);
    expect(new Set(seen).size).toBe(2);
    expectCard(readout, truth);
  });

  it('detects a crash by the velocity that the law leaves', () => {
    const readout = createLandingReadout();
    const rig = createRig({ scenario: 'crash' });
    const track: Track = { rows: [], dt: 0, tick: 0 };
    rig.fly(rig.loaded.scenario.duration, (view) => {
      updateLandingReadout(readout, view);
      follow(track, rig.truth);
    });
    const last = track.rows.at(-1)!;
    const place = last.slice(0, 3);
    const falling = -last.slice(3, 6).reduce((sum, v, k) => sum + v * place[k]!, 0) / Math.hypot(...place);
    expect(readout).toMatchObject({ status: 'crashed', touchdownShown: true });
    expect(readout.touchdown).toMatchObject({ outcome: 'crashed', bounces: 0 });
    expect(readout.touchdown.verticalSpeed).toBeCloseTo(falling, 6);
    expect(falling).toBeGreaterThan(30);
    // What is left moves no more.
    expect([readout.drift.x, readout.drift.y]).toEqual([NaN, NaN]);
  });

  it('stays until the next approach, and starts again with it', () => {
    const rig = createRig({ scenario: 'bounce' });
    const readout = createLandingReadout();
    const read = (view: WorldView) => updateLandingReadout(readout, view);
    rig.fly(24, read);
    const first = { ...readout.touchdown };
    expect(first).toMatchObject({ outcome: 'landed', bounces: 2 });
    // Up on the engine for 1 s, and down again.
    const begun = rig.now;
    while (rig.now < begun + 30) {
      const thrustLevel = rig.now < begun + 1 ? 1 : 0;
      read(rig.frame({ ...NEUTRAL_CONTROLS, thrustLevel, attitudeHold: true }));
      if (rig.now < begun + 3) expect(readout.touchdown).toEqual(first);
    }
    expect(readout.touchdown.verticalSpeed).not.toBe(first.verticalSpeed);
    expect(readout.touchdown.bounces).toBeLessThan(2);
    expect(readout.status).toBe('landed');
  });

  it('is empty for a ship that was on the ground from the start, or put there', () => {
    const readout = createLandingReadout();
    const rig = createRig({ scenario: 'launch' });
    rig.fly(0.5, (view) => updateLandingReadout(readout, view));
    expect(readout).toMatchObject({ status: 'landed', touchdownShown: false });
    const other = createRig({ scenario: 'bounce' });
    other.fly(24, (view) => updateLandingReadout(readout, view));
    expect(readout.touchdownShown).toBe(true);
    // 300 m to the north, landed.
    const site = { ...rig.loaded.scenario.site, latitude: rig.loaded.scenario.site.latitude + 0.01 };
    const elsewhere = value(loadScenario({ ...rig.loaded.scenario, site }));
    expect(other.authority.respawn(SHIP, elsewhere.ship)).toBeNull();
    other.fly(2, (view) => updateLandingReadout(readout, view));
    expect(readout).toMatchObject({ status: 'landed', touchdownShown: false });
  });
});

describe('the readout of a touchdown', () => {
  const touchdown = {
    ...NO_TOUCHDOWN,
    known: true,
    outcome: 'landed',
    verticalSpeed: 12.3,
    horizontalSpeed: 5,
    bounces: 1,
    slideMetres: 40,
    settleSeconds: 6.6,
    largestTilt: Math.PI / 20,
  } as const;
  const read = (state: Pose['state'], changes: Partial<ShipView> = {}) =>
    updateLandingReadout(createLandingReadout(), makeView({ state: state! }, { touchdown, ...changes }));

  it('is in degrees, and shown when landed, tipped or crashed, not while it goes on', () => {
    expect(read('landed').touchdown).toEqual({ ...touchdown, largestTilt: expect.closeTo(9, 12) as number });
    expect(read('landed').touchdownShown).toBe(true);
    expect(read('tipped').touchdownShown).toBe(true);
    expect(read('', { shownState: 'crashed' }).touchdownShown).toBe(true);
    expect(read('contact').touchdownShown).toBe(false);
    expect(read('').touchdownShown).toBe(false);
    expect(read('landed', { touchdown: NO_TOUCHDOWN }).touchdownShown).toBe(false);
    expect(read('landed', { provenance: 'stale' }).touchdownShown).toBe(false);
  });
});
