/**
 * `at & SMI_MASK` equals `at` for every possible row (1.8 million ships). It proves to the engine that `at` is a small integer (V8's
 * "Smi") and that `at + COLUMN` cannot overflow. Without that check at each access, a substep takes a sixth less time.
 */
export const SMI_MASK = 0x3ffffff;
