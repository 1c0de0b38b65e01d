import { err, ok, type Result } from '../../dynamics';
import type { ClientMessage, Hello, Pong } from '../../wire';
import { helloFor } from '../announcements';
import { queueInputs } from './inputQueue';
import { createPilot, type Pilot, takePing } from './pilots';
import { presentOf, type ServerState } from '../serverState';

const MAX_PILOTS = 10_000;

/** Lets a player join or rejoin as the pilot of `shipId`; '' is a spectator. Returns the hello, or null if the server sends none (`legacy`). */
export function join(server: ServerState, playerId: string, shipId: string): Result<Hello | null> {
  const { pilots, options } = server;
  if (playerId === '') return err('playerId: expected a non-empty string');
  const known = pilots.get(playerId);
  if (known === undefined && pilots.size >= MAX_PILOTS)
    return err(`players: the limit of ${MAX_PILOTS} is reached`);
  if (shipId !== '' && [...pilots.values()].some((p) => p.shipId === shipId && p.playerId !== playerId))
    return err(`shipId: ${shipId} is flown by another player`);
  const pilot = known ?? createPilot(playerId);
  pilot.shipId = shipId;
  pilot.fresh = true;
  pilots.set(playerId, pilot);
  return ok(options.legacy ? null : helloFor(server, pilot));
}

/** Handles a message of a client at wall second `now`: answers a ping, queues inputs. */
export function receive(
  server: ServerState,
  playerId: string,
  message: ClientMessage,
  now: number,
): Result<Pong | null> {
  const { pilots, counters } = server;
  const pilot = pilots.get(playerId);
  if (pilot === undefined || (message.kind === 'inputs' && pilot.shipId === '')) {
    counters.inputsWithoutShip++;
    return err(`playerId: ${playerId} ${pilot === undefined ? 'has not joined' : 'flies no ship'}`);
  }
  if (message.kind === 'ping') return ok(answerPing(server, pilot, message.id, now));
  const reason = queueInputs(pilot, counters, message.inputs, presentOf(server), now);
  return reason === null ? ok(null) : err(reason);
}

/** The answer to a ping, or null if this player sent too many within a wall second. */
function answerPing(server: ServerState, pilot: Pilot, id: number, now: number): Pong | null {
  const { tempo, schedule, counters, tick } = server;
  if (!takePing(pilot, now)) {
    counters.pingsFlooded++;
    return null;
  }
  counters.pings++;
  return { kind: 'pong', id, tick, sinceTick: tempo.paused() ? 0 : now - schedule.at };
}
