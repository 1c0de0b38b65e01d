/** Numbers per pose of a track, and poses per second. */
export const TRACK_STRIDE = 7;
export const TRACK_RATE = 10;
