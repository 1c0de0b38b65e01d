/** Counts of what pilots sent, by outcome. Monotonic. */
export interface Counters {
  inputsApplied: number;
  /** Applied after the substep of their stamp had been simulated. */
  inputsLate: number;
  /** With a sequence number that is already queued or applied. */
  inputsDuplicate: number;
  /** Never applied: an input with a higher sequence number was applied first. */
  inputsSuperseded: number;
  /** Refused: too far ahead. */
  inputsFromFuture: number;
  /** Refused: the queue was full. */
  inputsFlooded: number;
  /** Refused: malformed. */
  inputsMalformed: number;
  /** Refused: from a player who has not joined or flies no ship. */
  inputsWithoutShip: number;
  pings: number;
  pingsFlooded: number;
}

export function createCounters(): Counters {
  return {
    inputsApplied: 0,
    inputsLate: 0,
    inputsDuplicate: 0,
    inputsSuperseded: 0,
    inputsFromFuture: 0,
    inputsFlooded: 0,
    inputsMalformed: 0,
    inputsWithoutShip: 0,
    pings: 0,
    pingsFlooded: 0,
  };
}
