/**
 * The usual reference for a clock: of the last eight answered pings, the one with the least round trip is used (RFC 5905's
 * clock filter). Seconds; server time runs half that round trip behind the answer's arrival.
 */
export interface LeastRoundTrip {
  readonly samples: { readonly offset: number; readonly roundTrip: number }[];
}

const KEPT = 8;

export function createLeastRoundTrip(): LeastRoundTrip {
  return { samples: [] };
}

/** Takes the answer to a ping of client time `pinged`, sent at server time `answered`, that arrived at `now`. */
export function takeAnswer({ samples }: LeastRoundTrip, pinged: number, answered: number, now: number): void {
  if (now < pinged) return;
  samples.push({ offset: (pinged + now) / 2 - answered, roundTrip: now - pinged });
  if (samples.length > KEPT) samples.shift();
}

/** Server time at client time `now`; NaN before the first answer. */
export function serverTimeBy({ samples }: LeastRoundTrip, now: number): number {
  let best = samples[0];
  for (const one of samples) if (one.roundTrip < best!.roundTrip) best = one;
  return best === undefined ? Number.NaN : now - best.offset;
}
