import { flatTerrain, type TerrainHeight } from '../dynamics';
import { createRig, type MovingRig } from './camera/cameraRig';
import { createFraming, type Framing } from './camera/framing';
import { type CameraView, FIRST_AZIMUTH, FIRST_ELEVATION } from './camera/cameras';
import { groundPoint } from './ground/terrainLevel';
import { createTurn, type LocalFrame, type Turn } from './localFrame';
import type { Markers } from './overlays/markers';
import { createPlaces } from './overlays/overlayPlaces';
import type { OverlayChoice } from './overlays/overlays';
import type { SceneParts } from './sceneParts';
import { type Actors, createActors } from './ships/actors';
import { lookOf } from './sky/bodyLook';
import { type SceneLook, underSun } from './sky/underSun';
import { createCone, type ViewCone } from './camera/viewCone';

/** The scene view's state between frames. */
export interface SceneState {
  readonly parts: SceneParts;
  readonly actors: Actors;
  readonly rig: MovingRig;
  readonly choice: OverlayChoice;
  readonly markers: Markers;
  readonly translucent: Set<string>;
  readonly turn: Turn;
  readonly places: ReturnType<typeof createPlaces>;
  readonly cone: ViewCone;
  readonly opening: { across: number; upright: number };
  readonly framing: Framing;
  readonly point: Float64Array;
  /** The pad to land on next, local, m. */
  readonly pad: Float64Array;
  readonly groundY: (x: number, z: number) => number;
  terrain: TerrainHeight;
  /** The next view is the first one of another world. */
  isNewWorld: boolean;
  frame: LocalFrame | null;
  look: SceneLook;
  /** Degrees; null: as it is over the body by default. */
  sunElevation: number | null;
  cameraView: CameraView;
  watchedClass: string;
  /** Clock of the last frame, s; NaN before the first. */
  before: number;
}

/** The current frame: set by `rebuildIfNeeded` (surroundings.ts) before any other step. */
export const frameOf = (state: SceneState) => state.frame!;

export function createState(parts: SceneParts): SceneState {
  const point = new Float64Array(3);
  const state: SceneState = {
    parts,
    point,
    pad: new Float64Array(3),
    actors: createActors(),
    rig: createRig(FIRST_AZIMUTH, FIRST_ELEVATION, 24),
    choice: { ghost: false, errorSegment: false, contactNormal: false, footprint: false, forces: false },
    markers: { pads: [], touch: null },
    translucent: new Set(),
    turn: createTurn(),
    places: createPlaces(),
    cone: createCone(),
    opening: { across: 1, upright: 1 },
    framing: createFraming(),
    groundY(x, z) {
      groundPoint(point, 0, x, z, { frame: frameOf(state), terrainHeight: state.terrain });
      return point[1]!;
    },
    terrain: flatTerrain,
    isNewWorld: true,
    frame: null,
    look: underSun(lookOf(''), null),
    sunElevation: null,
    cameraView: 'follow',
    watchedClass: '',
    before: NaN,
  };
  return state;
}
