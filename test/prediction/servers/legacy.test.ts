import { describe, expect, it } from 'vitest';
import { BODIES, NEUTRAL_CONTROLS } from '../../../src/dynamics';
import { createPredictor } from '../../../src/prediction';
import {
  decodeShipStateJson,
  encodeShipStateJson,
  type ServerFrame,
  type ShipState,
} from '../../../src/wire';
import { flyAndMeasure } from '../measure';
import { createRig, value } from '../rig';

describe('the game’s own server: no hello, no acknowledgements, no fields 31 to 34, whole-tick inputs', () => {
  it.each(['settle', 'bounce', 'slide', 'topple', 'crash'])('%s stays within a centimetre', (scenario) => {
    const rig = createRig({ scenario, legacy: true });
    const measured = flyAndMeasure(rig, 24);
    measured.errors.sort((a, b) => a - b);
    expect(measured.errors[Math.floor(measured.errors.length * 0.99)]).toBeLessThan(0.01);
    expect(measured.wrongStates).toBe(0);
    expect(rig.view().diagnosis.helloReceived).toBe(false);
    expect(rig.notices.filter(({ kind }) => kind === 'retracted')).toEqual([]);
    expect(rig.notices.filter(({ kind }) => kind === 'confirmed').length).toBe(rig.truth.events.length);
  });

  it('applies own inputs at whole ticks, as the server does', () => {
    const rig = createRig({
      scenario: 'bounce',
      legacy: true,
      pilot: (game) => ({ ...NEUTRAL_CONTROLS, thrustLevel: game > 3.3 && game < 6.6 ? 0.12 : 0 }),
    });
    const measured = flyAndMeasure(rig, 14);
    expect(rig.sentInputs.map(({ substep }) => substep)).toEqual([0, 0]);
    expect(measured.worst).toBeLessThan(0.01);
    expect(rig.view().diagnosis.correctionsLateInput).toBe(0);
  });
});

describe('a page that pauses while a ship touches the ground, its impact speed not sent', () => {
  /** s after which the ship of `bounce` first touches the ground. */
  function firstTouch(tickRate: number): number {
    const rig = createRig({ scenario: 'bounce', legacy: true, tickRate });
    rig.fly(12);
    const { tick, substep } = rig.truth.events.find(({ type }) => type === 'ship.contact')!;
    return tick / tickRate + (substep ?? 0) * 0.01;
  }

  it.each([1, 10])('draws the bounce that the server has at %s Hz', (tickRate) => {
    const touch = firstTouch(tickRate);
    for (const pause of [0.4, 0.6, 0.9, 1.4, 2.6])
      for (const before of [0.05, 0.2, 0.5, 0.8]) {
        const rig = createRig({ scenario: 'bounce', legacy: true, tickRate });
        rig.fly(Math.max(0.1, touch - before));
        const until = rig.now + pause;
        while (rig.now < until) rig.receiveOnly();
        // After more than a second the page resynchronises, and what it drew before fades.
        if (pause > 1) rig.fly(1);
        const { worst } = flyAndMeasure(rig, 5);
        expect(worst, `paused for ${pause} s, ${before} s before the touch`).toBeLessThan(0.01);
      }
  });
});

describe('older and incomplete servers', () => {
  const moon = BODIES[0]!;
  const state = (more: Partial<ShipState>): ShipState => ({
    shipId: 's',
    playerId: '',
    name: 'S',
    shipClass: 'planetary_lander',
    position: [moon.position[0], moon.position[1], moon.position[2] + moon.radius + 4.56],
    velocity: moon.velocity,
    attitude: [0, 0, 0, 1],
    angularVelocity: moon.angularVelocity,
    ...NEUTRAL_CONTROLS,
    fuel: 1000,
    mass: 9000,
    landedBodyName: '',
    surfaceContactState: '',
    contactImpactSpeed: null,
    referenceBody: '',
    relativePosition: null,
    relativeVelocity: null,
    crashed: false,
    wheelMomentum: null,
    groundContactOffset: null,
    ...more,
  });
  const frame = (tick: number, ships: ShipState[], bodies = BODIES): ServerFrame => ({
    kind: 'frame',
    tick,
    tickRate: 1,
    timeScale: 1,
    paused: false,
    bodies,
    ships,
    events: [],
    lastInput: null,
  });

  it('treats a body landed on without a state as landed', () => {
    const predictor = createPredictor();
    predictor.receive(frame(5, [state({ landedBodyName: 'Luna' })]), 0);
    predictor.advance(null, 0.02);
    expect(predictor.view(0.02).ships[0]).toMatchObject({
      surfaceContactState: 'landed',
      provenance: 'confirmed',
    });
    expect(predictor.view(0.02).diagnosis.steppedSubsteps).toBe(0);
  });

  it('chooses the reference body itself when the server names none', () => {
    const predictor = createPredictor();
    predictor.receive(frame(5, [state({})]), 0);
    predictor.advance(null, 0.02);
    const view = predictor.view(0.02);
    expect(view.bodies[view.ships[0]!.body]!.name).toBe('Luna');
    expect(view.ships[0]!.groundRadius).toBe(moon.radius);
  });

  it('continues from the game’s JSON without bodies', () => {
    const predictor = createPredictor();
    const json: unknown = JSON.parse(JSON.stringify(encodeShipStateJson(state({ landedBodyName: 'Luna' }))));
    for (let tick = 1; tick <= 40; tick++) {
      const ship = value(decodeShipStateJson(json));
      predictor.receive(frame(tick, [ship], []), tick);
      predictor.advance(null, tick + 0.1);
      expect(predictor.view(tick + 0.1).ships[0]!.surfaceContactState).toBe('landed');
    }
    predictor.receive(frame(400, [value(decodeShipStateJson(json))], []), 400);
    predictor.advance(null, 400.1);
    expect(predictor.view(400.1).ships).toHaveLength(1);
  });
});
