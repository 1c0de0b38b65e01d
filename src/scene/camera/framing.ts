import type { PerspectiveCamera } from 'three';
import { type CameraRig, PAD_BELOW } from './cameraRig';
import { fieldOfView, type Opening } from './viewCone';

/** The picture's size and what panels cover of it, CSS pixels. */
export interface Framing {
  width: number;
  height: number;
  top: number;
  bottom: number;
}

export function createFraming(): Framing {
  return { width: 1, height: 1, top: 0, bottom: 0 };
}

/** Share of the picture's height that a ship and the ground under it need at first. */
const NEEDED = 0.6;
/** Least share of the height that counts as free, however much panels cover: the ship is never further away than NEEDED / FREE. */
const FREE = 0.2;
/** The pad's place below the ship, as a share of the way to the margin. */
const PAD_SHARE = 0.8;

/** Tangent of half the upright field of view. */
export function halfTangent({ fov }: PerspectiveCamera): number {
  return Math.tan((fov * Math.PI) / 360);
}

/** Aims the line of sight at the middle between the margins, and takes the eye so far away that the ship fits between them. */
export function frameShip(
  camera: PerspectiveCamera,
  rig: CameraRig,
  {
    framing,
    opening,
  }: { readonly framing: Framing; readonly opening: { -readonly [K in keyof Opening]: number } },
): void {
  const { width, height, top, bottom } = framing;
  const shift = (bottom - top) / 2;
  camera.aspect = width / height;
  camera.fov = fieldOfView(camera.aspect);
  if (shift === 0) camera.clearViewOffset();
  else camera.setViewOffset(width, height, 0, shift, width, height);
  camera.updateProjectionMatrix();
  const half = halfTangent(camera);
  const free = Math.max(1 - (top + bottom) / height, FREE);
  rig.reach = Math.max(1, NEEDED / free);
  rig.padBelow = Math.min(PAD_BELOW, PAD_SHARE * half * free);
  // The far side of a picture that is off its line of sight.
  opening.upright = half * (1 + (2 * Math.abs(shift)) / height);
  opening.across = half * camera.aspect;
}
