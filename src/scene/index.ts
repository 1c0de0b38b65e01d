/** The picture, in three alone: stage, ships, ground, sky, dust, overlays, floating origin. */
export { createStage, type Stage } from './stage';
export type { OverlayChoice } from './overlays';
