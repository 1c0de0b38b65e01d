/** The picture, in three alone: stage, ships, ground, sky, dust, overlays, floating origin. */
export { FINE, type Quality, qualityFor } from './quality';
export { createStage } from './sceneView';
export type { Stage } from './stage';
export type { Markers } from './overlays/markers';
export type { OverlayChoice } from './overlays/overlays';
export { CAMERA_VIEWS, type CameraView } from './camera/cameras';
