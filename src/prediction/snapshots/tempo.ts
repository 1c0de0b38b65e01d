import type { ServerFrame } from '../../wire';
import { forgetAfter } from '../simulation/rings/history';
import { hold } from '../simulation/replay';
import type { Simulation } from '../simulation/simulation';
import { followTickRate, horizonOf } from '../time/cadence';
import { sampleDown, sentAt } from '../time/clock';
import { setTempo, spanOf, wallOfTick } from '../time/timeline';
import { forgetAfter as forgetBodiesAfter } from './bodies/bodyTrack';
import { differs } from './classify';
import type { Receiver } from './receiver';

/** Takes the clock sample and the tempo of a frame; if the tempo changed, everything after its tick is simulated again. */
export function followTempo(sim: Simulation, receiver: Receiver, frame: ServerFrame, now: number): void {
  const { timeline } = sim;
  const { clock } = receiver;
  const first = timeline.spans.length === 0;
  const wasPaused = !first && spanOf(timeline, frame.tick).paused;
  // When the server sent the frame, server wall s, where the ticks do not give it.
  const untimed =
    first || frame.tick === sim.newestTick
      ? null
      : (sim.features.tickRates?.sentUntimed(sim, receiver, frame, now) ?? null);
  const wall = untimed ?? (wasPaused ? wallAfterPause(sim, receiver, now) : null);
  if (first) sampleDown(clock, 0, now);
  else if (wall === null) {
    const isOverdue =
      now - receiver.acceptedAt > horizonOf(sim.cadence, spanOf(timeline, frame.tick).tickRate, false);
    sampleDown(clock, wallOfTick(timeline, frame.tick), now, isOverdue);
  }
  const resumes = wasPaused && !frame.paused;
  const changes = untimed !== null || (!first && differs(sim, frame));
  // The pose at the present was simulated by the old tempo.
  if (changes) for (const track of sim.fleet.tracks) if (track.mode === 'stepping') hold(sim, track);
  if (changes) followTickRate(sim.cadence, spanOf(timeline, frame.tick).tickRate, frame.tickRate);
  // The server does not send at which of the ticks since the last frame the tempo changed.
  if (changes && frame.tick > sim.newestTick + 1) sim.bodiesKnown = false;
  setTempo(timeline, frame.tick, frame, resumes || frame.tick > sim.newestTick ? wall : null);
  if (changes) retime(sim, frame.tick);
  sim.newestTick = frame.tick;
}

/** A paused server keeps its schedule: a pause lasts a whole number of ticks. */
function wallAfterPause(sim: Simulation, receiver: Receiver, now: number): number {
  const span = sim.timeline.spans.at(-1)!;
  const beats = Math.round((sentAt(receiver.clock, now) - span.fromWall) * span.tickRate);
  return span.fromWall + Math.max(0, beats) / span.tickRate;
}

/** Forgets what was predicted after `tick` by the old tempo. */
function retime(sim: Simulation, tick: number): void {
  forgetBodiesAfter(sim.bodies, tick);
  for (const track of sim.fleet.tracks) {
    forgetAfter(track.history, tick);
    if (track.log !== null) sim.features.touchdown?.forgetLogsAfter(track.log, tick);
    track.replaying = false;
  }
  sim.frontIsStale = true;
}
