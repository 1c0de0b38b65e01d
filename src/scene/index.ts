/** The three.js view: scene view, ships, ground, sky, dust, overlays, floating origin. */
export { FINE, type Quality, qualityFor } from './quality';
export { createSceneView } from './createSceneView';
export { NIGHT_ELEVATION } from './sky/underSun';
export type { SceneView } from './sceneView';
export type { SceneOptions, SceneWarn } from './checks';
export type { Markers } from './overlays/markers';
export { OVERLAY_COLOURS, type OverlayChoice } from './overlays/overlays';
export { CAMERA_VIEWS, type CameraView } from './camera/cameras';
