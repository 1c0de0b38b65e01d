import { BODY_ATTITUDE, BODY_STRIDE } from '../../dynamics';
import type { Picture } from './picture';
import { quaternion, rotate, rotateBack, take } from './rotation';

/**
 * Converts a ship's offset to the axes of its new reference body, so that the drawn pose does not jump.
 * @param bodies rows of the present substep
 */
export function turnPicture(picture: Picture, bodies: Float64Array, index: number): void {
  const { ease } = picture;
  if (picture.body >= 0 && ease.active) {
    take(from, bodies, picture.body * BODY_STRIDE + BODY_ATTITUDE);
    take(to, bodies, index * BODY_STRIDE + BODY_ATTITUDE);
    for (const part of [ease.offset, ease.rate, ease.turn, ease.turnRate]) {
      rotate(part, from, part);
      rotateBack(part, to, part);
    }
  }
  picture.body = index;
}

const from = quaternion();
const to = quaternion();
