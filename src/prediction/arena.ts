/** Gives out arrays of zeros, one after another in one buffer. Throws a RangeError once the buffer is used up. */
export type Arena = (length: number) => Float64Array;

/**
 * An arena of `length` doubles for the arrays of one ship. To the garbage collector each buffer is three objects and often a block of
 * memory besides: a thousand new ships with a buffer for each array block a frame.
 */
export function createArena(length: number): Arena {
  const buffer = new ArrayBuffer(length * Float64Array.BYTES_PER_ELEMENT);
  let used = 0;
  return (taken) => {
    const array = new Float64Array(buffer, used * Float64Array.BYTES_PER_ELEMENT, taken);
    used += taken;
    return array;
  };
}

/** An identity quaternion, [x, y, z, w]. */
export function identity(arena: Arena): Float64Array {
  const quaternion = arena(4);
  quaternion[3] = 1;
  return quaternion;
}
