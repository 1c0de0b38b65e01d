/**
 * 32-bit FNV-1a hash of the bytes of doubles, little-endian on every machine. Hashes a trajectory's bits.
 * Start with FNV_OFFSET and pass each result to the next call.
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
