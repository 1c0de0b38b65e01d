import { quantities, SMI_MASK } from '../contact/quantities';

// Unrolled, since a loop takes three times as long.

/** Copies the ship's row into the first slots of `quantities`. */
export function copyIn(ships: Float64Array, row: number): void {
  const q = quantities;
  const at = row & SMI_MASK;
  q[0] = ships[at]!;
  q[1] = ships[at + 1]!;
  q[2] = ships[at + 2]!;
  q[3] = ships[at + 3]!;
  q[4] = ships[at + 4]!;
  q[5] = ships[at + 5]!;
  q[6] = ships[at + 6]!;
  q[7] = ships[at + 7]!;
  q[8] = ships[at + 8]!;
  q[9] = ships[at + 9]!;
  q[10] = ships[at + 10]!;
  q[11] = ships[at + 11]!;
  q[12] = ships[at + 12]!;
  q[13] = ships[at + 13]!;
  q[14] = ships[at + 14]!;
  q[15] = ships[at + 15]!;
  q[16] = ships[at + 16]!;
  q[17] = ships[at + 17]!;
  q[18] = ships[at + 18]!;
  q[19] = ships[at + 19]!;
  q[20] = ships[at + 20]!;
  q[21] = ships[at + 21]!;
  q[22] = ships[at + 22]!;
  q[23] = ships[at + 23]!;
  q[24] = ships[at + 24]!;
  q[25] = ships[at + 25]!;
  q[26] = ships[at + 26]!;
  q[27] = ships[at + 27]!;
  q[28] = ships[at + 28]!;
  q[29] = ships[at + 29]!;
  q[30] = ships[at + 30]!;
  q[31] = ships[at + 31]!;
  q[32] = ships[at + 32]!;
  q[33] = ships[at + 33]!;
  q[34] = ships[at + 34]!;
  q[35] = ships[at + 35]!;
}

/** Copies the columns that a substep changes back into the row: up to SURFACE_STATE, and CRASHED. */
export function copyOut(ships: Float64Array, row: number): void {
  const q = quantities;
  const at = row & SMI_MASK;
  ships[at] = q[0]!;
  ships[at + 1] = q[1]!;
  ships[at + 2] = q[2]!;
  ships[at + 3] = q[3]!;
  ships[at + 4] = q[4]!;
  ships[at + 5] = q[5]!;
  ships[at + 6] = q[6]!;
  ships[at + 7] = q[7]!;
  ships[at + 8] = q[8]!;
  ships[at + 9] = q[9]!;
  ships[at + 10] = q[10]!;
  ships[at + 11] = q[11]!;
  ships[at + 12] = q[12]!;
  ships[at + 13] = q[13]!;
  ships[at + 14] = q[14]!;
  ships[at + 15] = q[15]!;
  ships[at + 16] = q[16]!;
  ships[at + 17] = q[17]!;
  ships[at + 18] = q[18]!;
  ships[at + 20] = q[20]!;
}
