import type { Delivery, RunInput } from '../../scenarios';
import { type LoadedWorld, loadWorld, OWN_PLAYER, addGuest } from './loadedWorld';
import { loadOperation } from './operation';
import { operateWorld } from './operator';

/**
 * The server the page plays against: a scenario's authority behind a simulated connection, with an operator. No clock: wall
 * seconds are passed, so that a test plays it as the worker does.
 */
export interface Session {
  /** Carries out a command of the operator, or returns why not. */
  readonly operate: (operation: unknown, now: number) => string | null;
  /** Bytes from the page's client; nothing before a world is loaded. */
  readonly send: (bytes: Uint8Array, now: number) => void;
  /** Processes everything due by `now`. Returns the messages that have reached the client. */
  readonly run: (now: number) => Delivery[];
  /** When something happens next, wall seconds; Infinity when nothing will. */
  readonly nextAt: () => number;
  /** The pilot's inputs since the load, at the substeps where they acted. */
  readonly applied: () => readonly RunInput[];
  /** Another player joins beside the player's ship; returns the reason why it cannot, or null. */
  readonly join: (playerId: string, name: string, now: number) => string | null;
  readonly leave: (playerId: string) => void;
  readonly sendFrom: (playerId: string, bytes: Uint8Array, now: number) => void;
  /** Messages that have reached another player by `now`, after run(now). */
  readonly deliverTo: (playerId: string, now: number) => Delivery[];
  readonly world: () => { readonly scenario: string; readonly terrain: string };
}

export function createSession(): Session {
  let world: LoadedWorld | null = null;

  function operate(given: unknown, now: number): string | null {
    const checked = loadOperation(given);
    if (!checked.ok) return checked.reason;
    const operation = checked.value;
    if (operation.kind !== 'load')
      return world === null ? 'no world is loaded' : operateWorld(world, operation, now);
    const loaded = loadWorld(operation, now);
    if (!loaded.ok) return loaded.reason;
    world = loaded.value;
    return null;
  }

  return {
    operate,
    send: (bytes, now) => world?.link.send(OWN_PLAYER, bytes, now),
    run(now) {
      world?.link.run(now);
      return world?.link.deliver(OWN_PLAYER, now) ?? [];
    },
    nextAt: () => world?.link.nextAt() ?? Infinity,
    applied: () => world?.applied ?? [],
    join: (playerId, name, now) =>
      world === null ? 'no world is loaded' : addGuest(world, playerId, name, now),
    leave(playerId) {
      world?.link.drop(playerId);
      world?.link.authority.despawn(playerId);
    },
    sendFrom: (playerId, bytes, now) => world?.link.send(playerId, bytes, now),
    deliverTo: (playerId, now) => world?.link.deliver(playerId, now) ?? [],
    world: () => ({
      scenario: world?.loaded.scenario.name ?? '',
      terrain: world?.loaded.scenario.terrain ?? '',
    }),
  };
}
