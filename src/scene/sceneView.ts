import type { TerrainHeight } from '../dynamics';
import type { WorldView } from '../prediction';
import type { CameraView } from './camera/cameras';
import type { Markers } from './overlays/markers';
import type { OverlayChoice } from './overlays/overlays';

/** The picture: owns the WebGL context. Made by createSceneView, which throws where there is no WebGL 2. */
export interface SceneView {
  /** What lies over the picture; change it at will. */
  readonly overlays: OverlayChoice;
  /** Pads and the predicted touch; change it at will. */
  readonly markers: Markers;
  /** Right, away along the ground and up on the screen, ICRF axes, nine numbers; false before the first picture. */
  screenAxes(out: Float64Array): boolean;
  /** Metres that a CSS pixel spans at the ship's distance. */
  pixelSize(): number;
  /** The ground of the next draw; before the first call it is flat. */
  setTerrain(terrainHeight: TerrainHeight): void;
  /**
   * How high the sun is over the landing site, degrees; at or below 0 it is night. null: as the body has it by default. Takes effect
   * with the next draw, which lays out the ground again.
   */
  setSunElevation(elevation: number | null): void;
  /** Draws a ready view. `seconds` is a clock for easing and effects: monotone, and still while time stands still. */
  draw(view: WorldView, seconds: number): void;
  /** Whether the first picture stands: making the GPU's programs takes it seconds, while the calls have long returned. */
  hasDrawn(): boolean;
  /** CSS pixels and device pixels a CSS pixel. */
  resize(width: number, height: number, pixelRatio: number): void;
  /** rad; positive turns the eye to the right and up. */
  turnCamera(azimuth: number, elevation: number): void;
  /** Multiplies the distance. */
  zoomCamera(factor: number): void;
  /** Where the picture is taken from, at once. */
  setCamera(view: CameraView): void;
  /** Back to the first view, at once. */
  resetCamera(): void;
  /** Gives the GPU's memory back; nothing is drawn any more. */
  dispose(): void;
}
