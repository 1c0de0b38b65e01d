import { EVENT_DESTROYED } from '../../dynamics';
import type { ServerFrame } from '../../wire';
import type { EventNotice, ShipView } from '../drawn/view';
import {
  confirm,
  confirmByState,
  knownEvent,
  predict,
  pruneLedger,
  retract,
  settleByAgreement,
} from './ledger';
import type { Simulation } from '../simulation/simulation';
import type { Track } from '../simulation/track';
import type { Position } from '../time/timeline';
import type { Receiver } from '../snapshots/receiver';

/** How long a withdrawn prediction is shown, s. */
const WITHDRAWN_SHOWN = 2;

/** Handles an event that the dynamics reported in the substep that begins at `at`, in simulation pass `pass` of this ship. */
export function recordPredicted(
  sim: Simulation,
  track: Track,
  event: number,
  at: Position,
  pass: number,
): void {
  const notice = predict(track.ledger, event, at, sim.timeline, pass);
  if (notice !== null) sim.notices.push(notice);
}

/** The caller reports that the ship was destroyed, without a stamp: the event is of the newest tick. */
export function confirmEnd(sim: Simulation, { ledger }: Track): void {
  const notice = confirm(ledger, EVENT_DESTROYED, { tick: sim.newestTick, substep: 0 }, sim.timeline);
  if (notice !== null) sim.notices.push(notice);
}

/** Each event of the server confirms a predicted one or is reported by itself. Unknown types and unknown ships are ignored. */
export function confirmEvents(sim: Simulation, receiver: Receiver, { events }: ServerFrame): void {
  // The ledgers recognise repeated events among the newest; after an outage, all since the frame before it are new.
  const oldest = Math.max(receiver.firstTick, Math.min(receiver.eventsTick, sim.newestTick - sim.ringLength));
  for (const event of events) {
    const known = knownEvent(event);
    if (known === null) continue;
    receiver.sendsEvents = true;
    const track = sim.fleet.byId.get(event.shipId);
    if (track === undefined || event.tick < oldest || event.tick >= sim.newestTick) continue;
    const notice = confirm(track.ledger, known.event, known, sim.timeline);
    if (notice !== null) sim.notices.push(notice);
  }
}

/** Settles a frame's events and the predicted ones up to its tick: they are confirmed by event or state, or retracted. */
export function settleEvents(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  confirmEvents(sim, receiver, frame);
  for (const track of sim.fleet.tracks) {
    if (track.ledger.entries.length === 0 || track.serverTick !== frame.tick) continue;
    settleShip(sim, receiver, track, { frame, now });
    pruneLedger(track.ledger, frame.tick - sim.ringLength);
  }
  receiver.eventsTick = frame.tick;
}

function settleShip(
  sim: Simulation,
  receiver: Receiver,
  track: Track,
  { frame, now }: { readonly frame: ServerFrame; readonly now: number },
): void {
  const { ledger } = track;
  const { tick } = frame;
  if (track.agreedTick === tick && !track.replaying) {
    const by = { pass: track.pass, fromTick: track.adoptedTick };
    notifyAll(sim, track, now, () => {
      const notice = settleByAgreement(ledger, tick, sim.timeline, by);
      // Confirmed by state: the server does not send its events.
      if (notice?.kind === 'confirmed') receiver.sendsEvents = false;
      return notice;
    });
  }
  if (receiver.sendsEvents) notifyAll(sim, track, now, () => retract(ledger, tick, sim.timeline));
  else confirmStates(sim, track, frame);
}

/** Queues notices for the listeners; a retracted event is shown as withdrawn for a while. */
function notifyAll(sim: Simulation, { picture }: Track, now: number, next: () => EventNotice | null): void {
  for (let notice = next(); notice !== null; notice = next()) {
    sim.notices.push(notice);
    if (notice.kind !== 'retracted') continue;
    const word = notice.type.slice('ship.'.length);
    // Shown as 'crashed'.
    picture.status.withdrawn = (word === 'destroyed' ? 'crashed' : word) as ShipView['withdrawn'];
    picture.status.withdrawnUntil = now + WITHDRAWN_SHOWN;
  }
}

function confirmStates(sim: Simulation, track: Track, frame: ServerFrame): void {
  const state = frame.ships.find((candidate) => candidate.shipId === track.shipId);
  if (state === undefined) return;
  const shown =
    state.surfaceContactState === '' && state.landedBodyName !== '' ? 'landed' : state.surfaceContactState;
  for (;;) {
    const notice = confirmByState(track.ledger, frame.tick, shown, state.crashed);
    if (notice === null) return;
    sim.notices.push(notice);
  }
}
