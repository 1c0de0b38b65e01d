import type { ServerFrame } from '../../../wire';
import { forgetAfter } from '../../simulation/rings/history';
import { hold } from '../../simulation/replay';
import type { Simulation } from '../../simulation/simulation';
import { followTickRate, horizonOf } from '../../time/cadence';
import { sampleDown, sentAt } from '../../time/clock';
import { isSameTempo, setTempo, type Span, spanOf, wallOfTick } from '../../time/timeline';
import { forgetAfter as forgetBodiesAfter } from '../bodies/bodyTrack';
import type { Receiver } from '../receiver';

/** Takes the clock sample and the tempo of a frame; if the tempo changed, everything after its tick is simulated again. */
export function followTempo(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  if (sim.timeline.spans.length > 0) continueTimeline(sim, receiver, frame, now);
  else {
    sampleDown(receiver.clock, 0, now);
    setTempo(sim.timeline, frame.tick, frame, null);
  }
  sim.newestTick = frame.tick;
}

/** Takes a frame after the first, of the newest tick or a newer one. */
function continueTimeline(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const { timeline, newestTick } = sim;
  const { tick } = frame;
  const isNewer = tick > newestTick;
  const before = spanOf(timeline, tick);
  const untimed = isNewer ? (sim.features.tickRates?.sentUntimed(sim, receiver, frame, now) ?? null) : null;
  // When the server sent the frame, server wall s; null where its tick gives it.
  const wall = untimed ?? (before.paused ? wallAfterPause(before, receiver, now) : null);
  if (wall === null) {
    const isOverdue = now - receiver.acceptedAt > horizonOf(sim.cadence, before.tickRate, false);
    sampleDown(receiver.clock, wallOfTick(timeline, tick), now, isOverdue);
  }
  const changes = untimed !== null || !isSameTempo(before, frame);
  if (changes) changeTempo(sim, before, frame);
  const stillPaused = !isNewer && frame.paused;
  setTempo(timeline, tick, frame, stillPaused ? null : wall);
}

/** A paused server keeps its schedule: a pause lasts a whole number of ticks. */
function wallAfterPause({ fromWall, tickRate }: Span, { clock }: Receiver, now: number): number {
  const beats = Math.round((sentAt(clock, now) - fromWall) * tickRate);
  return fromWall + Math.max(0, beats) / tickRate;
}

/** Holds the drawn poses, and forgets what was predicted after the frame's tick by the tempo `before`. */
function changeTempo(sim: Simulation, before: Span, { tick, tickRate }: ServerFrame): void {
  const { tracks } = sim.fleet;
  for (const track of tracks) if (track.mode === 'stepping') hold(sim, track);
  for (const track of tracks) {
    forgetAfter(track.history, tick);
    if (track.log !== null) sim.features.touchdown?.forgetLogsAfter(track.log, tick);
    track.replaying = false;
  }
  forgetBodiesAfter(sim.bodies, tick);
  followTickRate(sim.cadence, before.tickRate, tickRate);
  // The server does not send at which of the ticks since the last frame the tempo changed.
  if (tick > sim.newestTick + 1) sim.bodiesKnown = false;
  sim.frontIsStale = true;
}
