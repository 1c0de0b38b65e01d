import type { TerrainHeight } from '../dynamics';
import type { WorldView } from '../prediction';
import type { CameraView } from './camera/cameras';
import type { Markers } from './overlays/markers';
import type { OverlayChoice } from './overlays/overlays';

/** The drawn scene; owns the WebGL context. Created by createSceneView, which throws where there is no WebGL 2. */
export interface SceneView {
  /** Which overlays are shown; may be changed at any time. */
  readonly overlays: OverlayChoice;
  /** Pads and the predicted touch; may be changed at any time. */
  readonly markers: Markers;
  /**
   * IDs of ships that are drawn see-through, without shadow, dust or flames, such as the ghost of an earlier flight; may be changed at any
   * time.
   */
  readonly translucent: Set<string>;
  /** Right, away along the ground and up on the screen, ICRF axes, nine numbers; false before the first picture. */
  screenAxes(out: Float64Array): boolean;
  /** Metres that a CSS pixel spans at the ship's distance. */
  pixelSize(): number;
  /**
   * Sets the terrain of a new world, which the next draw begins: dust, debris and the camera's motion end. Flat before the first call. The ground
   * is laid out again unless it is of the same terrain and the ship within 50 m of where it was.
   */
  setTerrain(terrainHeight: TerrainHeight): void;
  /**
   * Elevation of the sun at the landing site, degrees; at or below 0 it is night. null: the body's default. Takes effect
   * with the next draw, which lays out the ground again.
   */
  setSunElevation(elevation: number | null): void;
  /** Draws a ready view. `seconds`: a monotone clock for easing and effects, which stops while the game is paused. */
  draw(view: WorldView, seconds: number): void;
  /** Whether the GPU has drawn the first picture: compiling its programs takes seconds after the calls have returned. */
  hasDrawn(): boolean;
  /** Size in CSS pixels, and device pixels per CSS pixel. */
  resize(width: number, height: number, pixelRatio: number): void;
  /**
   * CSS pixels that panels cover at the picture's upper and lower edge: the ship is drawn in the middle of the rest, from far enough away to
   * fit into it. 0 and 0 at first.
   */
  setMargins(top: number, bottom: number): void;
  /** rad; positive turns the eye to the right and up. */
  turnCamera(azimuth: number, elevation: number): void;
  /** Multiplies the distance. */
  zoomCamera(factor: number): void;
  /** Changes the camera at once. */
  setCamera(view: CameraView): void;
  /** Returns to the first view at once. */
  resetCamera(): void;
  /** Releases the GPU's memory. Nothing can be drawn afterwards. */
  dispose(): void;
}
