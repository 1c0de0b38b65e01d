/**
 * sfc32 (Doty-Humphrey's PractRand): 32-bit integer arithmetic, so that a seed gives the same numbers in every engine.
 * Each call gives the next number in [0, 1).
 */
export type Random = () => number;

export function createRandom(seed: number): Random {
  let a = 0;
  let b = seed | 0;
  let c = Math.floor(seed / 4294967296) | 0;
  let counter = 1;
  function next(): number {
    const t = (((a + b) | 0) + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (c << 21) | (c >>> 11);
    c = (c + t) | 0;
    return (t >>> 0) / 4294967296;
  }
  // The author's seeding: rounds until every bit of the seed has reached every word.
  for (let i = 0; i < 15; i++) next();
  return next;
}

/** Mean 0, standard deviation 1, within ±3: the sum of three uniform numbers, since engines differ in log and cos. */
export function normalNoise(rng: Random): number {
  return 2 * (rng() + rng() + rng() - 1.5);
}
