import { createInputQueue, type InputQueue } from './inputQueue';

/** Pings of one player that are answered in a wall second. */
const MAX_PINGS_PER_SECOND = 100;

/** A player that has joined. It controls no ship but its own. */
export interface Pilot extends InputQueue {
  readonly playerId: string;
  /** '' for a spectator. */
  shipId: string;
  /** Pings answered in the wall second that began at `pingsSince`. */
  pings: number;
  pingsSince: number;
}

export function createPilot(playerId: string): Pilot {
  return { playerId, shipId: '', ...createInputQueue(), pings: 0, pingsSince: 0 };
}

/** Whether the pilot may have another ping answered at wall second `now`; counts it if so. */
export function takePing(pilot: Pilot, now: number): boolean {
  if (!(now - pilot.pingsSince < 1)) {
    pilot.pingsSince = now;
    pilot.pings = 0;
  }
  if (pilot.pings >= MAX_PINGS_PER_SECOND) return false;
  pilot.pings++;
  return true;
}
