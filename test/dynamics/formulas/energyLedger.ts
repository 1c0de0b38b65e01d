import {
  ANGULAR_VELOCITY,
  ATTITUDE,
  BODY_ANGULAR_VELOCITY,
  FUEL,
  IMPACT_SPEED,
  POSITION,
  SURFACE_STATE,
  TIPPED,
} from '../../../src/dynamics';
import { quaternionAt, see, type Trial, vectorAt } from '../provingGround';
import { conjugate, dot, lengthOf, plus, rotate } from '../vectors';

/** A ship's energy on the ground, J, relative to the ground, with gravity at the ship. */
export interface Energy {
  /** Of motion and of rotation. */
  readonly kinetic: number;
  /** m g height of the feet, 0 at the body's radius. */
  readonly height: number;
  /** weight · h · cos_tilt; 0 from 90° on, where the ship rests on its side. */
  readonly lean: number;
  /** ½ k penetration². */
  readonly spring: number;
  readonly total: number;
  /** Load on the feet, at most the weight: the normal force by its formula, N. */
  readonly held: number;
  readonly weight: number;
  readonly cosTilt: number;
}

export function energyOf(trial: Trial): Energy {
  const { ships, bodies, world } = trial;
  const body = world.bodies[0]!;
  const shipClass = world.shipClasses[0]!;
  const mass = shipClass.dryMass + ships[FUEL]!;
  const seen = see(trial);
  const weight = (mass * body.gravityParameter) / lengthOf(vectorAt(ships, POSITION)) ** 2;
  const spin = plus(vectorAt(ships, ANGULAR_VELOCITY), vectorAt(bodies, BODY_ANGULAR_VELOCITY), -1);
  const w = rotate(conjugate(quaternionAt(ships, ATTITUDE)), spin);
  const [x, y, z] = shipClass.inertiaTensor;
  const turning =
    0.5 *
    (shipClass.inertiaAtDry + shipClass.inertiaPerFuel * ships[FUEL]!) *
    (w[0] * dot(x, w) + w[1] * dot(y, w) + w[2] * dot(z, w));
  const kinetic = 0.5 * mass * (seen.climb ** 2 + seen.slide ** 2) + turning;
  const penetration = Math.max(0, -seen.height);
  const cosTilt = Math.max(0, Math.cos((seen.tilt * Math.PI) / 180));
  const spring = 0.5 * 100 * mass * penetration ** 2;
  const lean = weight * shipClass.groundContactOffset * cosTilt;
  const settling =
    ships[SURFACE_STATE] === TIPPED || ships[IMPACT_SPEED]! <= world.settings.contactBounceSpeed;
  const damping = settling ? 20 : 20 * world.settings.contactDampingRatio;
  const force = penetration > 0 ? mass * (100 * penetration - damping * seen.climb) : 0;
  const height = weight * seen.height;
  return {
    kinetic,
    height,
    lean,
    spring,
    total: kinetic + height + lean + spring,
    held: Math.min(Math.max(0, force), weight),
    weight,
    cosTilt,
  };
}
