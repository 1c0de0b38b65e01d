import type { World } from '../../dynamics';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import type { Timeline } from '../time/timeline';
import type { DrawnGround } from './snap/drawnGround';
import type { GroundPose } from './snap/groundSnap';
import type { snapToLevel } from './snap/levelSnap';
import { type Pose, pose } from './pose';
import { quaternion, vector } from './rotation';
import type { Springs } from './ease';
import type { Instant } from './status';
import type { ShipView } from './view';

/** The optional parts of drawing. */
export interface ViewFeatures {
  /** Puts ships on level ground; without, all are put on the ground point by point. */
  readonly snapToLevel?: typeof snapToLevel;
  /** Puts the server's state on the drawn ground. */
  readonly groundGhost?: (out: ShipView, track: Track, context: ViewContext, exactly: boolean) => void;
  /** The ground's own normal, if the settings require it. */
  readonly slopeBelow?: (out: ShipView, context: ViewContext) => Float64Array | null;
  /** The row of a ship that the caller chose not to predict. */
  readonly rowOfPolicy?: (sim: Simulation, track: Track, turned: TurnedBodies) => Float64Array;
}

/** The bodies' attitudes at the present. */
export interface TurnedBodies {
  /** Attitude and spin of each body, ICRF. */
  readonly bodyAttitudes: readonly Float64Array[];
  readonly bodySpins: readonly Float64Array[];
  /** The instant at which interpolated ships are drawn. */
  readonly playback: Playback;
}

/** The instant at which interpolated ships are drawn. */
export interface Playback {
  /** The timeline of the states' ticks. */
  readonly timeline: Timeline;
  /** Server wall s. */
  readonly at: number;
  /** Game s per wall s. */
  readonly timeScale: number;
}

/** The data of one view that its ships share, and scratch for the current ship. */
export interface ViewContext extends TurnedBodies {
  world: World;
  /** Of the current ship's body. */
  readonly ground: DrawnGround;
  /** Ships that may still be put on the ground point by point; for others the ground counts as level. */
  exactSnaps: number;
  readonly features: ViewFeatures;
  readonly at: Instant;
  readonly playback: { -readonly [K in keyof Playback]: Playback[K] };
  /** How fast corrections fade. */
  readonly springs: Springs;
  /** Of the current ship, in its body's axes: predicted pose, local up, and drawn pose. */
  readonly seen: Pose;
  /** One number: of the predicted position from the body's centre, m. */
  readonly distance: Float64Array;
  readonly normal: Float64Array;
  readonly drawn: GroundPose;
}

export function createViewContext(sim: Simulation, springs: Springs, features: ViewFeatures): ViewContext {
  const { timeline } = sim;
  return {
    world: sim.world,
    ground: { bodyName: '', radius: 0, terrainHeight: sim.world.terrainHeight },
    bodyAttitudes: sim.world.bodies.map(quaternion),
    bodySpins: sim.world.bodies.map(vector),
    exactSnaps: 0,
    features,
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
    distance: new Float64Array(1),
    normal: vector(),
    drawn: { ...pose(), grounded: false, groundOffset: 0 },
  };
}
