import { describe, expect, it } from 'vitest';
import { type Controls, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import type { ShipView } from '../../../src/prediction';
import { NETWORK_PRESETS, loadScenario } from '../../../src/scenarios';
import { corrections, flyAndMeasure, fromServer } from '../measure';
import { createRig, scenarioNamed, value } from '../rig';
import { distance } from '../samples';

describe('a server operated at run time', () => {
  it('pauses and resumes', () => {
    const rig = createRig({ scenario: 'bounce' });
    rig.fly(4);
    rig.authority.setPaused(true);
    rig.fly(2);
    const held = rig.view();
    expect(held.paused).toBe(true);
    const { tick, sinceTick } = held;
    const place = [...held.own!.position];
    rig.fly(3);
    expect(rig.view()).toMatchObject({ tick, sinceTick: 0 });
    expect(sinceTick).toBe(0);
    expect([...rig.view().own!.position]).toEqual(place);
    rig.authority.setPaused(false);
    rig.fly(3);
    expect(rig.view().paused).toBe(false);
    const measured = flyAndMeasure(rig, 10);
    expect(rig.view().tick).toBeGreaterThan(tick + 5);
    expect(measured.worst).toBeLessThan(1e-6);
    expect(measured.wrongStates).toBe(0);
    expect(corrections(rig)).toBe(0);
  });

  it.each([1, 20])(
    'at %i Hz lets a landed ship go where full throttle was set during a pause',
    (tickRate) => {
      const full = { ...NEUTRAL_CONTROLS, thrustLevel: 1 };
      let controls: Controls = NEUTRAL_CONTROLS;
      const rig = createRig({ scenario: 'settle', tickRate, pilot: () => controls });
      rig.fly(16);
      expect(rig.view().own!.surfaceContactState).toBe('landed');
      rig.authority.setPaused(true);
      rig.fly(3);
      controls = full;
      rig.fly(3);
      rig.authority.setPaused(false);
      rig.fly(4);
      expect(rig.view().own!.feetHeight).toBeGreaterThan(1);
      expect(corrections(rig)).toBe(0);
      expect(rig.view().diagnosis.errorPosition).toBeLessThan(1e-6);
    },
  );

  it.each([
    [1, 20, 1, 1],
    [20, 1, 1, 1],
    [1, 1, 1, 10],
    [5, 100, 1, 1],
  ])('changes rate from %i to %i Hz, scale %i to %i, in mid-bounce', (from, to, scale, toScale) => {
    const rig = createRig({ scenario: 'bounce', tickRate: from, timeScale: scale });
    rig.fly(5);
    rig.authority.setTickRate(to);
    rig.authority.setTimeScale(toScale);
    rig.fly(2.5);
    expect(rig.view()).toMatchObject({ tickRate: to, timeScale: toScale });
    const measured = flyAndMeasure(rig, 5);
    expect(measured.frames).toBeGreaterThan(60);
    expect(measured.worst).toBeLessThan(1e-6);
    expect(measured.wrongStates).toBe(0);
    expect(corrections(rig)).toBe(0);
  });

  it('reconnects in mid-topple', () => {
    const rig = createRig({ scenario: 'topple' });
    rig.fly(3.4);
    rig.exchange.drop('me');
    rig.fly(1.9);
    expect(rig.view().own!.provenance).toBe('stale');
    rig.exchange.reconnect('me', rig.now);
    rig.fly(1.5);
    expect(rig.view().own!.provenance).not.toBe('stale');
    expect(rig.view().own!.surfaceContactState).toBe('tipped');
    const measured = flyAndMeasure(rig, 4);
    expect(measured.worst).toBeLessThan(1e-6);
    expect(corrections(rig)).toBe(0);
    expect(rig.notices.filter(({ kind }) => kind === 'retracted')).toEqual([]);
  });

  it('applies inputs after a reconnect and loses none for good', () => {
    const thrust: Controls = { ...NEUTRAL_CONTROLS, thrustLevel: 0.12 };
    let wanted: Controls = NEUTRAL_CONTROLS;
    const rig = createRig({ scenario: 'bounce', pilot: () => wanted });
    rig.fly(4);
    rig.exchange.drop('me');
    wanted = thrust;
    rig.fly(1.5);
    rig.exchange.reconnect('me', rig.now);
    rig.fly(4);
    const measured = flyAndMeasure(rig, 4);
    expect(rig.view().own!.controls.thrustLevel).toBe(0.12);
    expect(measured.worst).toBeLessThan(1e-6);
    expect(rig.view().diagnosis.correctionsMismatch).toBe(0);
  });

  it('shows a crash only once the server does, and predicts a respawned ship', () => {
    const rig = createRig({ scenario: 'crash', network: { ...NETWORK_PRESETS.fourG, stallShare: 0 } });
    let early = 0;
    let predictedCrash = 0;
    rig.fly(4, ({ own }) => {
      if (own === null) return;
      const told = rig.notices.some(({ kind, type }) => kind === 'confirmed' && type === 'ship.destroyed');
      if (own.crashed && !told) predictedCrash += 1;
      if (own.shownState === 'crashed' && !told) early += 1;
    });
    expect(predictedCrash).toBeGreaterThan(10);
    expect(early).toBe(0);
    expect(rig.view().own!.shownState).toBe('crashed');
    const { snaps } = rig.view().diagnosis;
    rig.authority.respawn('ship-1', value(loadScenario(scenarioNamed('bounce'))).ship);
    for (let i = 0; i < 90 && rig.view().own!.shownState === 'crashed'; i++) rig.frame();
    expect(rig.view().own!.shownState).not.toBe('crashed');
    expect(rig.view().own!.crashed).toBe(false);
    expect(rig.view().diagnosis.snaps).toBe(snaps + 1);
    expect(flyAndMeasure(rig, 0.4).worst).toBeLessThan(1e-6);
  });

  it('names the field in which the server’s friction differs from its settings', () => {
    const rig = createRig({ scenario: 'slide', secretSettings: { contactFrictionKinetic: 0.3 } });
    rig.fly(6);
    const { diagnosis } = rig.view();
    expect(diagnosis.correctionsMismatch).toBeGreaterThan(2);
    expect(corrections(rig)).toBe(diagnosis.correctionsMismatch);
    expect(diagnosis.lastMismatch).toMatch(
      /^ship-1 at tick \d+: (position|velocity): server \[.+\], predicted \[.+\]$/,
    );
    expect(rig.view().own!.provenance).toBe('confirmed');
    rig.fly(30);
    expect(rig.view().own!.surfaceContactState).toBe('landed');
    expect(fromServer(rig)).toBeLessThan(10);
  });

  it('switches prediction off when time exceeds the budget, the farthest ships first, and on again', () => {
    const crash = scenarioNamed('crash');
    const rig = createRig({
      scenario: { ...crash, initial: { ...crash.initial, height: 400_000 } },
      timeScale: 100,
      tickRate: 20,
      others: 16,
      predictor: { maxSubstepsPerFrame: 1600 },
    });
    rig.fly(0.8);
    const { ships, own, diagnosis } = rig.view();
    const off = ships.filter(({ provenance }) => provenance === 'off');
    const on = ships.filter(({ provenance }) => provenance !== 'off');
    expect(off.length).toBeGreaterThan(5);
    expect(on.length).toBeGreaterThan(1);
    expect(own!.provenance).not.toBe('off');
    expect(diagnosis.budgetOverruns).toBeGreaterThan(0);
    const away = (ship: ShipView) => distance([...ship.serverPosition], [...own!.serverPosition]);
    expect(Math.max(...on.map(away))).toBeLessThanOrEqual(Math.min(...off.map(away)) * 1.05);
    rig.authority.setTimeScale(1);
    rig.fly(4);
    expect(rig.view().ships.filter(({ provenance }) => provenance === 'off')).toHaveLength(0);
  });
});

describe('the reported error', () => {
  it('is zero where the law is the same, and unknown before the first comparison', () => {
    const rig = createRig({ scenario: 'bounce' });
    expect(rig.view().diagnosis.errorPosition).toBeNaN();
    rig.fly(6);
    const { errorPosition, errorAngle } = rig.view().diagnosis;
    expect(errorPosition).toBeLessThan(1e-6);
    expect(errorAngle).toBeLessThan(1e-6);
  });

  it('is what the server changed outside the prediction, found with the next frame', () => {
    const rig = createRig({
      scenario: 'pointing',
      network: NETWORK_PRESETS.lan,
      pilot: () => NEUTRAL_CONTROLS,
    });
    rig.fly(4.4);
    expect(rig.view().diagnosis.errorPosition).toBeLessThan(1e-6);
    // A kick of 3 m/s and 0.2 rad/s, over the whole interval that was already predicted.
    expect(rig.authority.kick('ship-1', [3, 0, 0], [0, 0, 0.2])).toBeNull();
    rig.fly(0.8);
    const { errorPosition, errorAngle, correctionsMismatch } = rig.view().diagnosis;
    expect(correctionsMismatch).toBe(1);
    expect(errorPosition).toBeGreaterThan(2.99);
    expect(errorPosition).toBeLessThan(3.01);
    // Its spin turns with the ship; the added spin keeps its size.
    expect(errorAngle).toBeGreaterThan(0.19);
    expect(errorAngle).toBeLessThan(0.21);
    rig.fly(1);
    expect(rig.view().diagnosis.errorPosition).toBeLessThan(1e-6);
  });
});
