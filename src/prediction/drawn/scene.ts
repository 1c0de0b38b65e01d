import type { World } from '../../dynamics';
import type { Features, Simulation } from '../simulation/simulation';
import type { DrawnGround } from './snap/drawnGround';
import type { GroundPose } from './snap/groundSnap';
import type { Playback } from './interpolate';
import { type Pose, pose } from './pose';
import { quaternion, vector } from './rotation';
import type { Springs } from './ease';
import type { Instant } from './status';

/** What all ships of one view share. */
export interface Scene {
  world: World;
  /** Of the current ship's body. */
  readonly ground: DrawnGround;
  /** Attitude and spin of each body at the present, ICRF. */
  bodyAttitudes: Float64Array[];
  bodySpins: Float64Array[];
  /** Ships that may still be put on the ground point by point; for others the ground counts as level. */
  exactSnaps: number;
  readonly snapToLevel: Features['snapToLevel'];
  readonly at: Instant;
  /** The instant at which interpolated ships are drawn. */
  readonly playback: { -readonly [K in keyof Playback]: Playback[K] };
  /** How fast corrections fade. */
  readonly springs: Springs;
  /** Of the current ship, in its body's axes: predicted pose, local up, and drawn pose. */
  readonly seen: Pose;
  readonly normal: Float64Array;
  readonly drawn: GroundPose;
}

export function createScene(sim: Simulation, springs: Springs): Scene {
  const { timeline } = sim;
  return {
    world: sim.world,
    ground: { bodyName: '', radius: 0, terrainHeight: sim.world.terrainHeight },
    bodyAttitudes: sim.world.bodies.map(quaternion),
    bodySpins: sim.world.bodies.map(vector),
    exactSnaps: 0,
    snapToLevel: sim.features.snapToLevel,
    at: {
      now: 0,
      present: 0,
      elapsed: 0,
      staleAfter: 0,
      confirms: 0,
      paused: false,
      bodiesKnown: true,
      timeline,
      serverTick: Number.NaN,
      serverWall: 0,
    },
    playback: { timeline, at: 0, timeScale: 1 },
    springs,
    seen: pose(),
    normal: vector(),
    drawn: { ...pose(), grounded: false, groundOffset: 0 },
  };
}
