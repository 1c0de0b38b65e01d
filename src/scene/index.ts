/** The picture, in three alone: stage, ships, ground, sky, dust, overlays, floating origin. */
export { createStage, type Stage, type StageOptions } from './stage';
/** How a drawn ship stands; the page hands in prediction's standOnGround. */
export type { Standing, StandOnGround } from './shipActor';
export type { OverlayChoice } from './overlays';
