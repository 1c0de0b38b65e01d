/** Samples of a delay over the last 10 s of wall time: the least, and how far most lie above it. */
export interface Window {
  readonly at: Float64Array;
  readonly value: Float64Array;
  readonly sorted: Float64Array;
  /** Samples ever taken; slot = count mod length. */
  count: number;
  latest: number;
}

const SECONDS = 10;
/** More than arrive in 10 s from pings and a 20 Hz server; a faster one's window is shorter. */
const LENGTH = 256;
/** Share of the samples that lie below `spreadOf`. */
const MOST = 0.95;

export function createWindow(): Window {
  return {
    at: new Float64Array(LENGTH).fill(Number.NEGATIVE_INFINITY),
    value: new Float64Array(LENGTH),
    sorted: new Float64Array(LENGTH),
    count: 0,
    latest: Number.NaN,
  };
}

export function restart(window: Window): void {
  window.at.fill(Number.NEGATIVE_INFINITY);
  window.count = 0;
  window.latest = Number.NaN;
}

export function sample(window: Window, now: number, value: number): void {
  const slot = window.count % LENGTH;
  window.at[slot] = now;
  window.value[slot] = value;
  window.count += 1;
  window.latest = value;
}

/** The least of the last 10 s; of all samples, the newest, where the last 10 s have none; NaN without any. */
export function leastOf(window: Window, now: number): number {
  let least = window.latest;
  for (let i = 0; i < LENGTH; i++) {
    if (window.at[i]! >= now - SECONDS && window.at[i]! <= now && window.value[i]! < least)
      least = window.value[i]!;
  }
  return least;
}

/** How far above the least of the last 10 s 19 of 20 samples lie at most; 0 without samples. */
export function spreadOf(window: Window, now: number): number {
  let n = 0;
  for (let i = 0; i < LENGTH; i++) {
    if (window.at[i]! >= now - SECONDS && window.at[i]! <= now) window.sorted[n++] = window.value[i]!;
  }
  if (n === 0) return 0;
  window.sorted.fill(Number.POSITIVE_INFINITY, n);
  window.sorted.sort();
  return window.sorted[Math.min(n - 1, Math.floor(n * MOST))]! - window.sorted[0]!;
}
