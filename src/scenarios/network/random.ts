/**
 * sfc32 (Doty-Humphrey's PractRand): a seed's numbers are the same in every engine, being 32-bit integer arithmetic.
 * Each call gives the next number in [0, 1).
 */
export type Dice = () => number;

export function createDice(seed: number): Dice {
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
  // The author's own seeding: a few rounds until every bit of the seed has reached every word.
  for (let i = 0; i < 15; i++) next();
  return next;
}

/** About 0 with standard deviation 1, never beyond ±3: three uniform numbers added up, for no engine agrees on log and cos. */
export function bell(dice: Dice): number {
  return 2 * (dice() + dice() + dice() - 1.5);
}
