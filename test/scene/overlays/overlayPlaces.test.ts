import { Mesh, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import type { ShipView, WorldView } from '../../../src/prediction';
import { NETWORK_PRESETS } from '../../../src/scenarios';
import {
  createTurn,
  createLocalFrame,
  toBodyAxes,
  toLocalPoint,
  turnOfFrame,
} from '../../../src/scene/localFrame';
import { createPlaces, placeOverlays } from '../../../src/scene/overlays/overlayPlaces';
import { createOverlays } from '../../../src/scene/overlays/overlays';
import type { ShipActor } from '../../../src/scene/ships/shipActor';
import { createRig } from '../../prediction/rig';
import { makeView, type Pose } from '../../readout/views';

const SUN = { elevation: 15, azimuth: 60 };
const ALL = { ghost: true, errorSegment: true, contactNormal: true, footprint: true, forces: true };

/** The overlays of a view, as the scene view places them; the eye is at the frame's origin. */
function laidOver(view: WorldView, ship: ShipView, eye = new Float64Array(3)) {
  const body = view.bodies[ship.body]!;
  const frame = createLocalFrame(body, ship.ghostPosition, SUN);
  const turn = turnOfFrame(createTurn(), frame, body.attitude);
  const place = toLocalPoint(new Float64Array(3), frame, turn, ship.meshPosition);
  const mesh = new Mesh();
  mesh.position.set(place[0]!, place[1]!, place[2]);
  const places = createPlaces();
  placeOverlays(places, {
    view,
    ship,
    frame,
    turn,
    eye,
    groundY: () => 0,
    actor: { mesh, place } as unknown as ShipActor,
  });
  return places;
}

/** A view with its ghost, which is in body axes, where the ship is. */
function viewOf(pose: Pose) {
  const view = makeView(pose);
  toBodyAxes(view.own.ghostPosition, view.bodies[view.own.body]!.attitude, view.own.position);
  return view;
}

describe('overlays', () => {
  it('puts the ghost at the drawn ship where server and prediction agree, on ground that moves at 408 m/s', () => {
    const rig = createRig({ scenario: 'settle-earth' });
    rig.fly(5.5);
    const view = rig.view();
    const places = laidOver(view, view.own!);
    expect(places.ghostKnown).toBe(true);
    expect(places.ghost.distanceTo(places.ship)).toBeLessThan(2e-3);
    expect(places.error.length()).toBe(0);
  });

  it('draws no segment without a correction, however far the ship has flown since the server’s state', () => {
    const rig = createRig({ scenario: 'slide', network: NETWORK_PRESETS.lan });
    rig.fly(2.9);
    const view = rig.view();
    const places = laidOver(view, view.own!);
    expect(places.ghost.distanceTo(places.ship)).toBeGreaterThan(3);
    expect(places.error.length()).toBeLessThan(1e-9);
  });

  it.each([0, 10, 25, 40])(
    'puts the footprint on a slope of %i°, below the feet of a ship that is flush with it',
    (degrees) => {
      const rig = createRig({ scenario: 'settle' });
      rig.fly(6);
      const view = rig.view();
      const ship = view.own!;
      const up = new Vector3(...ship.position).normalize();
      const across = new Vector3(0.3, 0.5, -0.8).cross(up).normalize();
      const normal = up.clone().applyAxisAngle(across, (degrees * Math.PI) / 180);
      ship.groundNormal.set(normal.toArray());
      const places = laidOver(view, ship);
      expect((places.ground.angleTo(places.up) * 180) / Math.PI).toBeCloseTo(degrees, 4);
      const fromFoot = places.footprint.clone().sub(places.foot);
      expect(Math.abs(fromFoot.dot(places.ground))).toBeLessThan(1e-6);
      expect(places.ship.clone().sub(places.footprint).cross(places.ground).length()).toBeLessThan(1e-3);
      const overlays = createOverlays();
      overlays.update(ALL, places);
      const ring = overlays.group.children[2]!;
      const axis = new Vector3(0, 0, 1).applyQuaternion(ring.quaternion);
      expect(axis.angleTo(places.ground)).toBeLessThan(1e-6);
      overlays.dispose();
    },
  );

  it('draws the segment from the drawn ship to its predicted position', () => {
    const rig = createRig({ scenario: 'settle' });
    rig.fly(6);
    const view = rig.view();
    const ship = view.own!;
    const up = Float64Array.from(ship.position).map((v) => v / Math.hypot(...ship.position));
    for (let k = 0; k < 3; k++) ship.easedPosition[k] = ship.position[k]! + up[k]! * 2;
    const places = laidOver(view, ship);
    expect(places.error.distanceTo(new Vector3(0, -2, 0))).toBeLessThan(1e-6);
    const overlays = createOverlays();
    overlays.update(ALL, places);
    const segment = overlays.group.children[1]!;
    const end = new Vector3(0, 0, 1).applyMatrix4((segment.updateMatrix(), segment.matrix));
    expect(end.distanceTo(places.ship.clone().add(places.error))).toBeLessThan(1e-6);
    overlays.dispose();
  });

  it.each([0, 20, 300])(
    'puts the footprint of a ship %d m above a slope no further aside than from its own height',
    (clearance) => {
      const view = viewOf({ clearance });
      const ship = view.own;
      const { groundContactOffset } = ship;
      const up = new Vector3(...ship.position).normalize();
      const across = new Vector3(0.3, 0.5, -0.8).cross(up).normalize();
      const slope = Math.PI / 9;
      ship.groundNormal.set(up.clone().applyAxisAngle(across, slope).toArray());
      const { footprint, foot } = laidOver(view, ship);
      // Along the normal from the centre of mass to the plane through the foot; from no higher than a flush ship's.
      const height = clearance + groundContactOffset;
      const share = Math.min(1, groundContactOffset / (height * Math.cos(slope)));
      expect(footprint.distanceTo(foot)).toBeCloseTo(height * Math.sin(slope) * share, 3);
    },
  );

  it('draws thrust, weight and the force of the ground, per kilogram', () => {
    const forces = (state: '' | 'landed', lift: number) => {
      const view = viewOf({ clearance: 0, state, lift });
      const { up, thrust, weight, support } = laidOver(view, view.own);
      expect(up.length()).toBeCloseTo(1, 9);
      const [pull, push, carried] = [weight, thrust, support].map((force) => {
        expect(force.clone().cross(up).length()).toBeLessThan(1e-6);
        return force.dot(up);
      });
      return { pull: pull!, push: push!, carried: carried! };
    };
    const { own, bodies } = makeView({ clearance: 0 });
    const mass = own.shipClass.dryMass + own.fuel;
    const gravity = (6.6743e-11 * bodies[own.body]!.mass) / Math.hypot(...own.position) ** 2;
    const near = (value: number): unknown => expect.closeTo(value, 4);
    expect(forces('landed', 0.25 * gravity * mass)).toEqual({
      pull: near(-gravity),
      push: near(0.25 * gravity),
      carried: near(0.75 * gravity),
    });
    expect(forces('landed', 2 * gravity * mass).carried).toBeCloseTo(0, 9);
    expect(forces('', 0).carried).toBeCloseTo(0, 9);
  });

  it('are relative to the eye, and have the thrust’s own direction', () => {
    const view = viewOf({ clearance: 0, state: 'landed' });
    view.own.thrust.set([3e3, -4e3, 5e3]);
    const eye = new Vector3(7, -11, 13);
    const at = laidOver(view, view.own);
    const from = laidOver(view, view.own, Float64Array.from(eye));
    for (const name of ['ship', 'ghost', 'foot', 'footprint'] as const)
      expect(from[name].clone().add(eye).distanceTo(at[name]), name).toBeLessThan(1e-6);
    for (const name of ['error', 'ground', 'up', 'thrust', 'weight', 'support'] as const)
      expect(from[name].distanceTo(at[name]), name).toBe(0);
    const mass = view.own.shipClass.dryMass + view.own.fuel;
    expect(at.thrust.length()).toBeCloseTo(Math.hypot(3, 4, 5) * (1e3 / mass), 9);
    // Which way it points does not depend on how the axes lie.
    const along = new Vector3(3, -4, 5).normalize().dot(new Vector3(...view.own.position).normalize());
    expect(at.thrust.clone().normalize().dot(at.up)).toBeCloseTo(along, 9);
    expect(at.legRadius).toBe(view.own.shipClass.legRadius);
  });

  it('are shown if they are chosen and visible', () => {
    const view = viewOf({ clearance: 0, state: 'landed', lift: 2e3 });
    for (let k = 0; k < 3; k++) view.own.easedPosition[k] = view.own.position[k]! * (1 + 1e-6);
    const places = laidOver(view, view.own);
    const overlays = createOverlays();
    const shown = (choice: Partial<typeof ALL>, changes: object = {}) => {
      const none = {
        ghost: false,
        errorSegment: false,
        contactNormal: false,
        footprint: false,
        forces: false,
      };
      overlays.update({ ...none, ...choice }, { ...places, ...changes });
      return overlays.group.children.map(({ visible }) => (visible ? 1 : 0)).join('');
    };
    // Ghost, segment and ring, then the arrows of the normal, thrust, weight and support.
    expect(shown({})).toBe('0000000');
    expect(shown({ ghost: true })).toBe('1000000');
    expect(shown({ ghost: true }, { ghostKnown: false })).toBe('0000000');
    expect(shown({ errorSegment: true })).toBe('0100000');
    expect(shown({ errorSegment: true }, { error: new Vector3(0.01, 0, 0) })).toBe('0000000');
    expect(shown({ errorSegment: true }, { error: new Vector3(0.011, 0, 0) })).toBe('0100000');
    expect(shown({ footprint: true })).toBe('0010000');
    expect(shown({ contactNormal: true })).toBe('0001000');
    expect(shown({ forces: true })).toBe('0000111');
    expect(shown({ forces: true }, { thrust: new Vector3() })).toBe('0000011');
    const [, , ring, normal] = overlays.group.children;
    expect(ring!.scale.x).toBe(places.legRadius);
    shown({ contactNormal: true });
    expect(normal!.position.distanceTo(places.foot)).toBe(0);
    // 4 m long: its shaft ends in the head's last half metre.
    expect([normal!.children[0]!.scale.z, normal!.children[1]!.position.z]).toEqual([
      expect.closeTo(3.6, 9),
      expect.closeTo(3.5, 9),
    ]);
    overlays.dispose();
  });
});
