import { type BufferGeometry, type Group, Mesh, type ShaderMaterial, Vector3 } from 'three';
import { quat, vec3 } from 'gl-matrix';
import type { ShipView, WorldView } from '../../prediction';
import { createDustState, type DustState } from '../effects/dustSources';
import { commandedTurn, commandsPower, buildJets, canBurn, showPower, writePower } from '../effects/jets';
import { type LocalFrame, rotate, toLocalPoint, type Turn } from '../localFrame';
import { buildShip } from './models/models';
import type { ShipMaterial } from './shipMaterial';
import type { ShipModel } from './shipModel';
import { crumple } from './wreck';

/** m: a class may have its centre of mass at its feet; sizes are based on at least this height. */
export const MIN_HEIGHT = 2;

/** One ship in the scene. Places and velocities in local axes, doubles. */
export interface ShipActor {
  readonly className: string;
  readonly model: ShipModel;
  readonly jets: Mesh<BufferGeometry, ShaderMaterial>;
  readonly power: Float32Array;
  readonly place: Float64Array;
  readonly velocity: Float64Array;
  readonly turn: Float64Array;
  readonly blows: Float64Array;
  /** Of the four legs, m. */
  readonly compression: Float32Array;
  readonly dust: DustState;
  /** Height of the centre of mass over the feet, m, for sizes: at least MIN_HEIGHT. */
  readonly height: number;
  /** The frame in which it was last posed, and the number of frames. */
  seen: number;
  posed: number;
  wasWreck: boolean;
  /** Drawn see-through, without shadow, dust or flames. */
  isTranslucent: boolean;
  /** Share of the sun that reaches it, 0 … 1. */
  sunlit: number;
  readonly shadow: ThrownShadow;
}

/** Where a ship's shadow falls, found from the ship at `from`. Local axes, m. */
export interface ThrownShadow {
  /** NaN before the first time. */
  readonly from: Float64Array;
  readonly at: Vector3;
  /** Of the ground there, unit, found from the ship at `slopeFrom`. */
  readonly normal: Vector3;
  readonly slopeFrom: Float64Array;
}

/** Geometries by class and air: built once, shared by all ships of the class. */
export interface ModelCache {
  model(ship: ShipView): ShipModel;
  jets(ship: ShipView, inAir: boolean): BufferGeometry;
  dispose(): void;
}

export function createModelCache(): ModelCache {
  const models = new Map<string, ShipModel>();
  const jets = new Map<string, BufferGeometry>();
  const model = (ship: ShipView) => {
    const { name } = ship.shipClass;
    const known = models.get(name) ?? buildShip(ship.shipClass);
    models.set(name, known);
    return known;
  };
  return {
    model,
    jets(ship, inAir) {
      const key = `${ship.shipClass.name} ${inAir}`;
      const known = jets.get(key) ?? buildJets(model(ship), inAir);
      jets.set(key, known);
      return known;
    },
    dispose() {
      for (const known of models.values()) known.geometry.dispose();
      for (const known of jets.values()) known.dispose();
    },
  };
}

export interface ShipResources {
  readonly cache: ModelCache;
  readonly hull: ShipMaterial;
  readonly jet: ShaderMaterial;
}

export function createActor(ship: ShipView, shipResources: ShipResources, inAir: boolean): ShipActor {
  const model = shipResources.cache.model(ship);
  const power = new Float32Array(36);
  const jets = new Mesh(shipResources.cache.jets(ship, inAir), shipResources.jet);
  jets.frustumCulled = false;
  jets.renderOrder = 3;
  jets.visible = false;
  // Most are at rest and not lit: placeJets moves those in sight.
  jets.matrixAutoUpdate = false;
  showPower(jets, power);
  return {
    className: ship.shipClass.name,
    model,
    jets,
    power,
    place: new Float64Array(3),
    velocity: new Float64Array(3),
    turn: new Float64Array(4),
    blows: new Float64Array(3),
    compression: new Float32Array(4),
    dust: createDustState(),
    height: Math.max(ship.shipClass.groundContactOffset, MIN_HEIGHT),
    seen: 0,
    posed: 0,
    wasWreck: false,
    isTranslucent: false,
    sunlit: 1,
    shadow: {
      from: new Float64Array(3).fill(NaN),
      at: new Vector3(),
      normal: new Vector3(0, 1, 0),
      slopeFrom: new Float64Array(3).fill(NaN),
    },
  };
}

export function removeActor(actor: ShipActor, group: Group): void {
  group.remove(actor.jets);
}

/** Puts a burning ship's jets where the ship is; `eye` local, m. */
export function placeJets({ jets, place, turn }: ShipActor, eye: Float64Array): void {
  jets.position.set(place[0]! - eye[0]!, place[1]! - eye[1]!, place[2]! - eye[2]!);
  jets.quaternion.set(turn[0]!, turn[1]!, turn[2]!, turn[3]!);
  jets.updateMatrix();
}

const rates = new Float64Array(3);
const asked = new Float64Array(3);
const spin = new Float64Array(3);
const inverse = new Float64Array(4);

/** Sets the ship's pose and the power of its nozzles. */
export function poseActor(
  actor: ShipActor,
  ship: ShipView,
  view: WorldView,
  frame: LocalFrame,
  turn: Turn,
): void {
  actor.posed += 1;
  toLocalPoint(actor.place, frame, turn, ship.meshPosition);
  quat.multiply(actor.turn, turn.quaternion, ship.meshAttitude);
  const [wx, wy, wz] = view.bodies[ship.body]!.angularVelocity;
  const x = ship.position[0]!;
  const y = ship.position[1]!;
  const z = ship.position[2]!;
  spin[0] = ship.velocity[0]! - (wy * z - wz * y);
  spin[1] = ship.velocity[1]! - (wz * x - wx * z);
  spin[2] = ship.velocity[2]! - (wx * y - wy * x);
  rotate(actor.velocity, turn.matrix, spin);
  // A crashed ship's row keeps its speed at the crash.
  if (ship.crashed) actor.velocity.fill(0);

  for (let leg = 0; leg < 4; leg++) actor.compression[leg] = ship.legCompression[leg]!;
  actor.blows.fill(0);
  actor.blows[2] = -1;
  vec3.transformQuat(actor.blows, actor.blows, actor.turn);
  // The model is the class's, moved along its axis until its feet are the ship's.
  const raised = ship.shipClass.groundContactOffset - ship.groundContactOffset;
  for (let k = 0; k < 3; k++) actor.place[k] = actor.place[k]! - raised * actor.blows[k]!;
  // Not before the server has confirmed it.
  if (ship.shownState === 'crashed') crumple(actor, ship.shipClass.groundContactOffset);

  const burns = !ship.crashed && canBurn(ship.shipClass, ship.fuel) && commandsPower(ship.controls);
  actor.jets.visible = burns;
  if (!burns) return;
  quat.conjugate(inverse, ship.attitude);
  vec3.transformQuat(rates, ship.angularVelocity, inverse);
  commandedTurn(asked, ship.controls, rates);
  if (ship.surfaceContactState === 'landed') asked.fill(0);
  actor.jets.visible = writePower(actor.power, actor.model, ship.controls, asked);
}
