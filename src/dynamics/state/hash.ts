/**
 * FNV-1a over the bytes of doubles, 32 bits, little-endian on every machine: a hash of a trajectory's bits.
 * Chain calls with the last result; start with FNV_OFFSET.
 */
const FNV_OFFSET = 0x811c9dc5;

export function hashRows(rows: Float64Array, hash: number = FNV_OFFSET): number {
  let h = hash;
  for (const value of rows) {
    VIEW.setFloat64(0, value, true);
    for (let i = 0; i < 8; i++) h = Math.imul(h ^ VIEW.getUint8(i), 0x01000193);
  }
  return h >>> 0;
}

const VIEW = new DataView(new ArrayBuffer(8));
