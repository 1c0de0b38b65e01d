import { describe, expect, it } from 'vitest';
import { createServerState } from '../../src/authority/serverState';
import { spawn } from '../../src/authority/ships/shipTable';
import { frameOf, MOON, moonWith, runTo, shipOf, valueOf } from './moon';

describe('ships', () => {
  it('refuses an invalid spawn by name and leaves the world unchanged', () => {
    const authority = moonWith('opening');
    const order = { shipId: 'two', playerId: 'bob', name: 'Two', ship: shipOf('settle') };
    expect(authority.spawn({ ...order, shipId: 'own' })).toContain('shipId');
    expect(authority.spawn({ ...order, shipId: '' })).toContain('shipId');
    // A name of more than 128 characters or with half a surrogate would invalidate every later frame.
    for (const field of ['shipId', 'playerId', 'name'] as const) {
      expect(authority.spawn({ ...order, [field]: 'x'.repeat(129) })).toBe(
        `${field}: expected at most 128 characters, got 129`,
      );
      expect(authority.spawn({ ...order, [field]: 'a\ud800' })).toBe(
        `${field}: expected well-formed Unicode`,
      );
    }
    expect(authority.spawn({ ...order, ship: { ...order.ship, shipClass: 'brick' } })).toContain('shipClass');
    expect(authority.spawn({ ...order, ship: { ...order.ship, fuel: Number.NaN } })).toContain('fuel');
    expect(frameOf(authority).ships).toHaveLength(1);
    const own = frameOf(authority).ships[0]!;
    expect(authority.spawn(order)).toBeNull();
    expect(frameOf(authority).ships).toEqual([own, expect.objectContaining({ shipId: 'two' })]);
  });

  it('are at most 10,000', () => {
    const { ships, bodies, world } = valueOf(createServerState(MOON));
    const add = (shipId: string) =>
      spawn(ships, { shipId, playerId: 'bob', name: shipId, ship: shipOf('settle') }, bodies, world);
    expect(add('first')).toBeNull();
    ships.entries.push(...Array.from({ length: 9998 }, () => ships.entries[0]!));
    expect(add('last')).toBeNull();
    expect(add('one more')).toBe('ships: the limit of 10000 is reached');
  });

  it('removes one ship without changing the others', () => {
    const authority = moonWith('opening');
    const ship = shipOf('settle');
    for (const shipId of ['two', 'three'])
      expect(authority.spawn({ shipId, playerId: 'bob', name: shipId, ship })).toBeNull();
    runTo(authority, 1);
    const [own, , three] = frameOf(authority).ships;
    expect(authority.despawn('two')).toBeNull();
    expect(frameOf(authority).ships).toEqual([own, three]);
    expect(authority.despawn('two')).toContain('two');
    runTo(authority, 3);
    expect(frameOf(authority).ships.map(({ surfaceContactState }) => surfaceContactState)).toEqual([
      '',
      'landed',
    ]);
  });

  it('removes a crashed ship from the simulation until it is respawned, over the same ground', () => {
    const authority = moonWith('crash');
    const start = frameOf(authority).ships[0]!;
    const before = frameOf(authority).bodies[0]!.attitude;
    runTo(authority, 2);
    expect(frameOf(authority).events.map(({ type }) => type)).toEqual(['ship.destroyed']);
    const wreck = frameOf(authority).ships[0]!;
    expect(wreck).toMatchObject({ crashed: true, surfaceContactState: '', landedBodyName: '' });
    runTo(authority, 500);
    expect(frameOf(authority).ships[0]!.relativePosition).toEqual(wreck.relativePosition);
    expect(authority.respawn('own')).toBeNull();
    const { ships, bodies } = frameOf(authority);
    expect(ships[0]).toMatchObject({ crashed: false, fuel: start.fuel });
    // The Moon has turned by 1.33 mrad about its pole in 500 s: so has the place, 1,633 km from the axis.
    const moved = Math.hypot(
      ...ships[0]!.relativePosition!.map((value, k) => value - start.relativePosition![k]!),
    );
    expect(moved).toBeCloseTo(1737464.56 * Math.cos((28.6854 * Math.PI) / 180) * 2.6617e-6 * 500, 0);
    // Half the rotation, from the difference of the quaternions: in their product it would be lost to rounding.
    const half = Math.hypot(...bodies[0]!.attitude.map((value, k) => value - before[k]!));
    expect(half).toBeCloseTo(2.6617e-6 * 250, 8);
    runTo(authority, 503);
    expect(frameOf(authority).ships[0]!.crashed).toBe(true);
  });

  it('kicks a ship, waking it from the ground, and refuses an invalid kick', () => {
    const authority = moonWith('launch');
    expect(authority.kick('own', [0, 0, Number.NaN], [0, 0, 0])).toContain('dv');
    expect(authority.kick('own', [0, -10_001, 0], [0, 0, 0])).toContain('dv');
    expect(authority.kick('own', [0, 0, 0], [1e9, 0, 0])).toContain('spin');
    expect(authority.kick('nobody', [0, 0, 0], [0, 0, 0])).toContain('nobody');
    expect(frameOf(authority).ships[0]!.surfaceContactState).toBe('landed');
    const up = frameOf(authority).ships[0]!.relativePosition!.map((value) => (value * 3) / 1737404.56);
    expect(authority.kick('own', [up[0]!, up[1]!, up[2]!], [0, 0, 0])).toBeNull();
    expect(frameOf(authority).ships[0]!.surfaceContactState).toBe('');
    runTo(authority, 1);
    expect(frameOf(authority).ships[0]!.surfaceContactState).toBe('');
    runTo(authority, 6);
    expect(frameOf(authority).ships[0]!.surfaceContactState).toBe('landed');
    expect(frameOf(authority).ships[0]!.contactImpactSpeed).toBeGreaterThan(1);
    // Downward it slides, and so it does by spin alone. That contact began without an impact.
    const contact = { surfaceContactState: 'contact', contactImpactSpeed: 0 };
    expect(authority.kick('own', [-up[0]!, -up[1]!, -up[2]!], [0, 0, 0])).toBeNull();
    expect(frameOf(authority).ships[0]).toMatchObject(contact);
    const other = moonWith('launch');
    expect(other.kick('own', [0, 0, 0], [0, 0, 0.001])).toBeNull();
    expect(frameOf(other).ships[0]).toMatchObject(contact);
  });

  it('adds a kick’s velocity and spin along each axis', () => {
    const authority = moonWith('opening');
    const before = frameOf(authority).ships[0]!;
    expect(authority.kick('own', [1, -2, 4], [0.125, -0.25, 0.5])).toBeNull();
    const after = frameOf(authority).ships[0]!;
    const added = (name: 'relativeVelocity' | 'angularVelocity') =>
      after[name]!.map((value, k) => value - before[name]![k]!);
    expect(added('relativeVelocity')).toEqual([1, -2, 4].map((value) => expect.closeTo(value, 9) as number));
    expect(added('angularVelocity')).toEqual(
      [0.125, -0.25, 0.5].map((value) => expect.closeTo(value, 12) as number),
    );
  });

  it.each([
    [0, 1],
    [1, 2],
    [2, 0],
  ])('knows upward from each component of a kick: down along %i, more up along %i', (down, up) => {
    for (const share of [1.2, 0.8]) {
      const authority = moonWith('launch');
      const place = frameOf(authority).ships[0]!.relativePosition!;
      const dv: [number, number, number] = [0, 0, 0];
      dv[down] = -Math.sign(place[down]!);
      dv[up] = (share * Math.abs(place[down]!)) / place[up]!;
      expect(authority.kick('own', dv, [0, 0, 0])).toBeNull();
      expect(frameOf(authority).ships[0]!.surfaceContactState).toBe(share > 1 ? '' : 'contact');
    }
  });
});
