import { describe, expect, it } from 'vitest';
import { createAuthority } from '../../src/authority';
import {
  BODIES,
  BODY_STRIDE,
  readBodyMotion,
  readShip,
  SHIP_CLASSES,
  SHIP_STRIDE,
  TERRAINS,
} from '../../src/dynamics';
import { runScenario, type Scenario, SCENARIOS } from '../../src/scenarios';
import { PROTOCOL_VERSION } from '../../src/protocol';
import { decodeServerMessage, encodeServerMessage } from '../../src/wire';
import { frameOf, input, MOON, moonWith, runTo, shipOf, valueOf } from './moon';

/** The scenario played through messages: inputs sent as a client's records, states read from frames. */
function play(scenario: Scenario) {
  const run = valueOf(runScenario(scenario));
  const { loaded, world } = run;
  const authority = valueOf(
    createAuthority({
      settings: scenario.settings,
      shipClasses: SHIP_CLASSES,
      bodies: [loaded.body],
      terrain: scenario.terrain,
      terrains: TERRAINS,
      tickRate: scenario.tickRate,
      timeScale: scenario.timeScale,
    }),
  );
  expect(authority.spawn({ shipId: 's', playerId: 'p', name: 'n', ship: loaded.ship })).toBeNull();
  valueOf(authority.join('p', 's'));
  const frames = [frameOf(authority, 'p')];
  const ticks = run.ships.length / SHIP_STRIDE - 1;
  let next = 0;
  for (let tick = 0; tick < ticks; tick++) {
    // Sent a tick ahead, so that none is refused as too far in the future.
    while (next < loaded.inputs.length && loaded.inputs[next]!.tick <= tick) {
      const { substep, controls } = loaded.inputs[next++]!;
      const inputs = [{ seq: next, tick: loaded.inputs[next - 1]!.tick, substep, controls }];
      valueOf(authority.receive('p', { kind: 'inputs', inputs }, tick));
    }
    authority.tick(tick + 1);
    frames.push(frameOf(authority, 'p'));
  }
  return { run, world, frames };
}

describe('the world loop', () => {
  it.each(SCENARIOS.map((scenario) => [scenario.name, scenario] as const))(
    'simulates %s to the same bits and events as the dynamics alone',
    (_name, scenario) => {
      const { run, world, frames } = play(scenario);
      for (const [tick, frame] of frames.entries()) {
        const expected = readShip(run.ships, tick * SHIP_STRIDE, world);
        const ship = frame.ships[0]!;
        expect({
          shipClass: ship.shipClass,
          referenceBody: ship.referenceBody,
          relativePosition: ship.relativePosition,
          relativeVelocity: ship.relativeVelocity,
          attitude: ship.attitude,
          angularVelocity: ship.angularVelocity,
          fuel: ship.fuel,
          wheelMomentum: ship.wheelMomentum,
          groundContactOffset: ship.groundContactOffset,
          surfaceContactState: ship.surfaceContactState,
          contactImpactSpeed: ship.contactImpactSpeed,
          crashed: ship.crashed,
        }).toEqual(expected);
        expect(frame.bodies[0]).toMatchObject(readBodyMotion(run.bodies, tick * BODY_STRIDE));
      }
      const events = frames.flatMap((frame) => frame.events);
      expect(events.map(({ type, tick, substep }) => ({ type, tick, substep }))).toEqual(run.events);
    },
  );

  it('computes ICRF position and velocity from the body and the relative state', () => {
    const authority = moonWith('opening');
    runTo(authority, 3);
    const { bodies, ships } = frameOf(authority);
    const [body, ship] = [bodies[0]!, ships[0]!];
    for (let k = 0; k < 3; k++) {
      expect(ship.position[k]).toBe(body.position[k]! + ship.relativePosition![k]!);
      expect(ship.velocity[k]).toBe(body.velocity[k]! + ship.relativeVelocity![k]!);
    }
    expect(body.position[0]).toBeCloseTo(MOON.bodies[0]!.position[0] + 3 * MOON.bodies[0]!.velocity[0], 3);
    expect(ship.mass).toBe(8000 + ship.fuel);
  });

  it('sends a hello and frames that survive the wire unchanged', () => {
    const authority = moonWith('opening');
    const hello = valueOf(authority.join('ann', 'own'));
    expect(hello).toMatchObject({
      kind: 'hello',
      protocolVersion: PROTOCOL_VERSION,
      shipId: 'own',
      terrain: 'flat',
      inputGranularity: 'substep',
    });
    expect(valueOf(decodeServerMessage(encodeServerMessage(hello!)))).toEqual(hello);
    runTo(authority, 2);
    const frame = frameOf(authority);
    expect(frame.events.map(({ type }) => type)).toEqual(['ship.contact']);
    expect(valueOf(decodeServerMessage(encodeServerMessage(frame)))).toEqual(frame);
  });

  it('reports the events of an interval once, with the boundary that ends it', () => {
    const authority = moonWith('opening');
    runTo(authority, 2);
    expect(frameOf(authority).events).toHaveLength(1);
    expect(frameOf(authority).events[0]!.tick).toBe(1);
    runTo(authority, 3);
    expect(frameOf(authority).events).toHaveLength(0);
  });

  it('gives a flying ship the nearest body as reference from a tick’s start on', () => {
    const bodies = BODIES.filter(({ name }) => name === 'Earth' || name === 'Luna');
    const authority = moonWith('opening', { bodies });
    const earth = bodies.find(({ name }) => name === 'Earth')!;
    const moon = bodies.find(({ name }) => name === 'Luna')!;
    // 10,000 km above Earth, given relative to the Moon.
    const relativePosition = earth.position.map(
      (value, k) => value - moon.position[k]! + (k === 0 ? 1.6e7 : 0),
    );
    const ship = { ...shipOf('opening'), relativePosition: relativePosition as [number, number, number] };
    expect(authority.spawn({ shipId: 'far', playerId: 'bob', name: 'Far', ship })).toBeNull();
    runTo(authority, 1);
    expect(frameOf(authority).ships.map(({ referenceBody }) => referenceBody)).toEqual(['Luna', 'Earth']);
    const { ships, bodies: moved } = frameOf(authority);
    const far = ships[1]!;
    expect(Math.hypot(...far.relativePosition!)).toBeCloseTo(1.6e7, -5);
    // In ICRF beside the body that it is relative to.
    const { position, velocity } = moved.find(({ name }) => name === 'Earth')!;
    expect(far.position).toEqual(position.map((value, k) => value + far.relativePosition![k]!));
    expect(far.velocity).toEqual(velocity.map((value, k) => value + far.relativeVelocity![k]!));
  });

  it('has no frame for a client that has not joined, and refuses a ship that is already flown', () => {
    const authority = moonWith('opening');
    expect(authority.frameFor('bob')).toBeNull();
    expect(authority.join('bob', 'own')).toEqual({
      ok: false,
      reason: 'shipId: own is flown by another player',
    });
    valueOf(authority.join('bob', ''));
    expect(frameOf(authority, 'bob').ships).toHaveLength(1);
    expect(authority.leave('bob')).toBeNull();
    expect(authority.leave('bob')).toContain('bob');
  });

  it.each([
    ['settings.contactCrashSpeed', { settings: { contactCrashSpeed: Number.NaN } }],
    ['tickRate', { tickRate: 200 }],
    ['timeScale', { timeScale: 0 }],
    ['terrain', { terrain: 'toString' }],
    ['tick', { tick: -1 }],
    ['bodies[0]', { bodies: [{ ...MOON.bodies[0]!, radius: 0 }] }],
    ['bodies[1]', { bodies: [MOON.bodies[0]!, MOON.bodies[0]!] }],
    ['bodies: expected 1 to 256, got 257', { bodies: Array(257).fill(MOON.bodies[0]!) }],
    ['bodies[1]', { bodies: Array(256).fill(MOON.bodies[0]!) }],
    ['shipClasses: expected 1 to 256, got 257', { shipClasses: Array(257).fill(MOON.shipClasses[0]!) }],
    ['shipClasses[1]', { shipClasses: Array(256).fill(MOON.shipClasses[0]!) }],
    ['bodies', { bodies: [] }],
    ['shipClasses[0]', { shipClasses: [{ ...SHIP_CLASSES[0]!, dryMass: -1 }] }],
  ])('refuses %s by name', (field, options) => {
    const made = createAuthority({ ...MOON, ...options });
    expect(made.ok ? '' : made.reason).toContain(field);
  });
});

describe('a game server of today', () => {
  it('sends no hello, leaves out fields 31 to 34, acknowledges nothing and applies whole ticks', () => {
    const authority = moonWith('launch', { legacy: true });
    expect(valueOf(authority.join('ann', 'own'))).toBeNull();
    valueOf(authority.receive('ann', { kind: 'inputs', inputs: [input(1, 0, 30, { thrustLevel: 1 })] }, 0.1));
    runTo(authority, 1);
    expect(frameOf(authority)).toMatchObject({ lastInput: null });
    expect(frameOf(authority).ships[0]).toMatchObject({
      contactImpactSpeed: null,
      referenceBody: '',
      relativePosition: null,
      relativeVelocity: null,
      surfaceContactState: 'landed',
      thrustLevel: 0,
    });
    runTo(authority, 2);
    expect(frameOf(authority).ships[0]).toMatchObject({ surfaceContactState: '', thrustLevel: 1 });
  });
});
