/** The scene at a ship on Luna, as far as posing and placing ships read it. */
import { Group, Vector3 } from 'three';
import type { ShipView, WorldView } from '../../../src/prediction';
import { createCone } from '../../../src/scene/camera/viewCone';
import { createJetMaterial } from '../../../src/scene/effects/jets';
import { createLocalFrame, createTurn, toBodyAxes, turnOfFrame } from '../../../src/scene/localFrame';
import type { SceneState } from '../../../src/scene/sceneState';
import { createActors } from '../../../src/scene/ships/actors';
import { createModelCache, type ShipActor } from '../../../src/scene/ships/shipActor';
import { createShipMaterial } from '../../../src/scene/ships/shipMaterial';
import { placeShips, poseShips } from '../../../src/scene/shipsInScene';
import { makeShip, makeView, NORMAL } from '../../readout/views';

export const shipResources = {
  cache: createModelCache(),
  hull: createShipMaterial(),
  jet: createJetMaterial(),
};

const bodyOf = ({ bodies, own }: WorldView) => bodies[own!.body]!;

/** A view of ships by id, all at the body of the player's ship by default. */
export function viewOf(ships: readonly Partial<ShipView>[]): WorldView {
  const view = makeView({ clearance: 100 });
  return {
    ...view,
    ships: ships.map((ship) => ({
      ...makeShip({ clearance: 100 }),
      own: false,
      body: view.own.body,
      ...ship,
    })),
  };
}

const view = viewOf([{ shipId: 'a' }]);
const under = new Float64Array(3);
toBodyAxes(under, bodyOf(view).attitude, Float64Array.from(NORMAL));
export const frame = createLocalFrame(bodyOf(view), under, { azimuth: 60, elevation: 15 });
export const turn = turnOfFrame(createTurn(), frame, bodyOf(view).attitude);
export const body = view.own!.body;

/** Only what posing and placing ships read of the scene. */
export function createState(groundY: (x: number, z: number) => number = () => 0, shadowY = () => 0) {
  const done: unknown[] = [];
  const put: Record<string, { sunlit: number; watched: boolean }> = {};
  const shadows: { at: Vector3; normal: Vector3; height: number }[] = [];
  const seenThrough: string[] = [];
  const actors = createActors();
  const nameOf = (actor: ShipActor) => [...actors.byId].find(([, each]) => each === actor)![0];
  const state = {
    ...{
      turn,
      frame,
      actors,
      groundY,
      look: { air: null },
      translucent: new Set<string>(),
      cone: createCone(),
      rig: { eye: new Float64Array(3) },
    },
    parts: {
      ...{ jets: new Group(), shipResources, ground: { shadowY } },
      light: { direction: new Vector3(0.8, 0.6, 0) },
      crash: { begin: (_place: unknown, size: number) => done.push(['crash', size]) },
      dust: { throwGrain: () => done.push('grain') },
      hulls: {
        ...{ clear: () => done.push('clear'), finish: () => done.push('finish') },
        put: (actor: ShipActor, _eye: unknown, watched: boolean) =>
          (put[nameOf(actor)] = { sunlit: actor.sunlit, watched }),
      },
      translucent: {
        clear: () => undefined,
        put: (actor: ShipActor) => seenThrough.push(nameOf(actor)),
      },
      shadows: {
        ...{ clear: () => undefined, finish: () => undefined },
        put: (_place: unknown, at: Vector3, normal: Vector3, _eye: unknown, height: number) =>
          shadows.push({ at: at.clone(), normal: normal.clone(), height }),
      },
    },
  };
  const given = state as unknown as SceneState;
  const pose = (...ships: Partial<ShipView>[]) => {
    const seen = viewOf(ships);
    poseShips(given, seen, seen.own!, 0.02);
    return done.splice(0);
  };
  const actor = (name: string) => actors.byId.get(name)!;
  return {
    state: given,
    pose,
    put,
    seenThrough,
    shadows,
    actor,
    place: (watched: string) => placeShips(given, actor(watched)),
  };
}
