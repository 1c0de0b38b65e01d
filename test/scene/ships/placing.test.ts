/** Where ships, their shadows and wrecks are placed in the scene. */
import { Group, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../../src/dynamics';
import type { ShipView } from '../../../src/prediction';
import { clearActors, createActors, poseActors } from '../../../src/scene/ships/actors';
import { makeShip } from '../../readout/views';
import { body, createState, frame, shipResources, turn, viewOf } from './shipsAtLuna';

const near = (values: Iterable<number>, digits = 9) =>
  [...values].map((value): unknown => expect.closeTo(value, digits));

describe('drawn ships', () => {
  function createScene() {
    const actors = createActors();
    const jets = new Group();
    const place = { frame, turn, jets, shipResources, inAir: false };
    const pose = (...ships: Partial<ShipView>[]) => {
      const posed: string[] = [];
      poseActors(actors, viewOf(ships), body, place, (_actor, { shipId }) => posed.push(shipId));
      return { posed, kept: [...actors.byId.keys()], jets: jets.children.length };
    };
    return { actors, jets, pose };
  }

  const { controls } = makeShip({ clearance: 100 });
  const burning = { fuel: 100, controls: { ...controls, thrustLevel: 1 } };
  const idle = { fuel: 100, controls: { ...controls, thrustLevel: 0, attitudeHold: false } };

  it('are those of the watched ship’s body, as long as they are in the view', () => {
    const { actors, jets, pose } = createScene();
    const far = { shipId: 'far', body: body + 1 };
    expect(pose({ shipId: 'a', ...burning }, far, { shipId: 'b', ...burning })).toEqual({
      posed: ['a', 'b'],
      kept: ['a', 'b'],
      jets: 2,
    });
    const [first] = actors.byId.values();
    expect(pose({ shipId: 'a', ...burning }, { shipId: 'c', ...burning })).toEqual({
      posed: ['a', 'c'],
      kept: ['a', 'c'],
      jets: 2,
    });
    expect(actors.byId.get('a')).toBe(first);
    expect([first!.posed, actors.byId.get('c')!.posed, actors.count]).toEqual([2, 1, 2]);
    const hauler = makeShip({ shipClass: 'cargo_hauler' }).shipClass;
    expect(pose({ shipId: 'a', shipClass: hauler, ...burning })).toEqual({
      posed: ['a'],
      kept: ['a'],
      jets: 1,
    });
    expect(actors.byId.get('a')!.className).toBe('cargo_hauler');
    expect(jets.children).toEqual([actors.byId.get('a')!.jets]);
    clearActors(actors, jets);
    expect([actors.byId.size, jets.children.length]).toEqual([0, 0]);
  });

  it('have jets in the scene while they burn', () => {
    const { actors, jets, pose } = createScene();
    expect(pose({ shipId: 'a', ...idle }, { shipId: 'b', ...burning }).jets).toBe(1);
    expect(jets.children).toEqual([actors.byId.get('b')!.jets]);
    expect(pose({ shipId: 'a', ...burning }, { shipId: 'b', ...idle }).jets).toBe(1);
    expect(jets.children).toEqual([actors.byId.get('a')!.jets]);
    expect(pose({ shipId: 'a', ...idle }, { shipId: 'b', ...idle }).jets).toBe(0);
  });

  it('are where the view has them, and move over the ground', () => {
    const { actors, pose } = createScene();
    const moving = makeShip({ clearance: 100, east: 3, north: 4, up: -12 });
    pose({ ...moving, body, shipId: 'a' });
    const { place, velocity, height } = actors.byId.get('a')!;
    expect(place[1]).toBeCloseTo(100 + moving.shipClass.groundContactOffset, 3);
    expect(height).toBe(Math.max(2, moving.shipClass.groundContactOffset));
    expect([velocity[1], Math.hypot(velocity[0]!, velocity[2]!)]).toEqual(near([-12, 5], 6));
  });

  it('crash once, unless they are first seen as wrecks', () => {
    const { pose } = createState();
    const wreck = { shipId: 'a', shownState: 'crashed' as const, crashed: true };
    const height = makeShip().shipClass.groundContactOffset;
    expect(pose({ shipId: 'a' })).toEqual([]);
    const crash = pose(wreck);
    expect(crash.filter((what) => what !== 'grain')).toEqual([['crash', 2 * height]]);
    // As much dust as a touch at 40 m/s or more.
    expect(crash.filter((what) => what === 'grain')).toHaveLength(40 + 40 * 11);
    expect(pose(wreck)).toEqual([]);
    expect(pose({ ...wreck, shipId: 'b' })).toEqual([]);
    pose({ shipId: 'a' });
    expect(pose(wreck).filter((what) => what !== 'grain')).toHaveLength(1);
  });

  it('that are translucent have no hull, shadow, flames, dust or crash', () => {
    const { state, pose, place, put, seenThrough, shadows, actor } = createState(undefined, () => -1000);
    state.translucent.add('b');
    const burning = { controls: { ...NEUTRAL_CONTROLS, thrustLevel: 1 }, fuel: 100 };
    pose({ shipId: 'a' }, { shipId: 'b', ...burning });
    expect(actor('b').jets.visible).toBe(false);
    const wreck = { shownState: 'crashed' as const, crashed: true };
    expect(pose({ shipId: 'a' }, { shipId: 'b', ...wreck })).toEqual([]);
    place('a');
    expect([Object.keys(put), seenThrough, shadows]).toEqual([['a'], ['b'], []]);
    state.translucent.clear();
    pose({ shipId: 'a' }, { shipId: 'b', ...burning });
    expect(actor('b').jets.visible).toBe(true);
  });

  it('raise dust when they touch: all of up to twelve ships, otherwise only the player’s', () => {
    const grains = (count: number, own: boolean) => {
      const { pose } = createState();
      const others = Array.from({ length: count - 1 }, (_, i) => ({ shipId: String(i) }));
      pose({ shipId: 'a', own }, ...others);
      return pose({ shipId: 'a', own, surfaceContactState: 'contact', impactSpeed: 2 }, ...others).length;
    };
    expect([grains(11, false), grains(12, false), grains(12, true)]).toEqual([40 + 22, 0, 40 + 22]);
  });

  it('are lit by their share above the terrain’s shadow, and cast a shadow where the map does not reach', () => {
    const { pose, place, put, shadows, actor } = createState();
    pose({ shipId: 'a' }, { shipId: 'b' }, { shipId: 'c' }, { shipId: 'd' });
    const { height } = actor('a');
    for (const [name, over] of [
      ['a', 1],
      ['b', 0],
      ['c', -1],
      ['d', 0.5],
    ] as const)
      actor(name).place.set([10, over * height, 20]);
    place('a');
    const share = (sunlit: number, watched: boolean) => ({ sunlit, watched });
    expect(put).toEqual({
      a: share(1, true),
      b: share(0.5, false),
      c: share(0, false),
      d: share(0.75, false),
    });
    expect(shadows.map((shadow) => shadow.height)).toEqual([height, height]);
  });

  it('cast their shadows down-sun along the slope, computed again once they have moved 3 cm', () => {
    let rise = 0.05;
    const { pose, place, shadows, actor } = createState(
      (x, z) => rise * x - 0.02 * z,
      () => -1000,
    );
    pose({ shipId: 'a' }, { shipId: 'b' });
    const shadowAt = (x: number, y: number, z: number) => {
      actor('b').place.set([x, y, z]);
      shadows.length = 0;
      place('a');
      return shadows[0]!;
    };
    // On the ray (10, 30, 20) − t (0.8, 0.6, 0): 30 − 0.6 t = 0.05 (10 − 0.8 t) − 0.4.
    const t = (30 - 0.5 + 0.4) / (0.6 - 0.04);
    const { at, normal } = shadowAt(10, 30, 20);
    expect(Math.abs(at.x - (10 - 0.8 * t))).toBeLessThan(0.3);
    expect([at.y, at.z]).toEqual(near([0.05 * at.x - 0.4, 20]));
    expect([...normal]).toEqual(near(new Vector3(-0.05, 1, 0.02).normalize()));
    rise = 0.2;
    expect(shadowAt(10.02, 30, 20.02).at).toEqual(at);
    const moved = shadowAt(10.04, 30, 20);
    expect(moved.at.x).not.toBeCloseTo(at.x, 1);
    expect(moved.normal).toEqual(normal);
    expect(shadowAt(10, 31.4, 20).normal).toEqual(normal);
    expect([...shadowAt(10, 31.6, 20).normal]).toEqual(near(new Vector3(-0.2, 1, 0.02).normalize()));
  });

  it('are drawn up to 30 m outside the picture, the watched one always', () => {
    const { state, pose, place, put, actor } = createState();
    pose({ shipId: 'a' }, { shipId: 'b' }, { shipId: 'c' });
    Object.assign(state.cone, { whole: false, inward: Float64Array.of(1, 0, 1, 0) });
    for (const [name, x] of [
      ['a', -500],
      ['b', -29],
      ['c', -31],
    ] as const)
      actor(name).place[0] = x;
    place('a');
    expect(Object.keys(put)).toEqual(['a', 'b']);
  });
});
