/** The picture, in three alone: stage, ships, ground, sky, dust, overlays, floating origin. */
export { FINE, type Quality, qualityFor } from './quality';
export { createStage, type Stage } from './sceneView';
export type { OverlayChoice } from './overlays/overlays';
