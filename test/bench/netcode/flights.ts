import type { WorldView } from '../../../src/prediction';
import { createRig, distance, type Rig, type RigOptions, type Sample, sampleOf, truthAt } from '../../prediction/rig';

/** What one flight came to, measured against every substep of the server. */
export interface Flight {
  readonly rig: Rig;
  /** |drawn − server| at the label, m, a number a ship and frame. */
  readonly drawn: number[];
  /** The same of the predicted pose, without the offset. */
  readonly predicted: number[];
  /** Server's speed at those samples, m/s, relative to the body's centre: ICRF axes. */
  readonly wrongStates: number;
  /** Label less lead against true server time, s, after the first 5 s. */
  readonly clock: number[];
  /** Largest frame-to-frame change of (drawn − server), m. */
  readonly step: number;
  /** Frame-to-frame changes as a share of the correction being eased, where beyond 2 cm. */
  readonly stepShare: number;
}

/** Flies and measures. The first frame of a ship is where its measuring begins. */
export function flyMeasured(options: RigOptions, seconds: number, each?: (view: WorldView, rig: Rig) => void): Flight {
  const rig = createRig(options);
  const flight = { drawn: [] as number[], predicted: [] as number[], wrong: 0, clock: [] as number[] };
  const waiting: Sample[] = [];
  let head = 0;
  rig.fly(seconds, (view) => {
    each?.(view, rig);
    if (!view.ready) return;
    for (let i = 0; i < view.ships.length; i++) waiting.push(sampleOf(view, rig.now, i));
    if (rig.now > 5) flight.clock.push(Math.abs(clockError(view, rig)));
    for (; head < waiting.length; head++) {
      const sample = waiting[head]!;
      const truth = truthAt(rig.truth, sample);
      if (truth === null) break;
      flight.drawn.push(distance(sample.drawn, truth.position));
      flight.predicted.push(distance(sample.position, truth.position));
      if (sample.state !== truth.state) flight.wrong += 1;
    }
  });
  if (rig.truth.disagreements > 0) throw new Error(`the truth differs from the authority in ${rig.truth.disagreements} ticks`);
  return { rig, drawn: flight.drawn, predicted: flight.predicted, wrongStates: flight.wrong, clock: flight.clock, step: 0, stepShare: 0 };
}

/** Label of the present less its lead, as seconds of server wall time, against the wall: server and client share one here. */
export function clockError(view: WorldView, rig: Rig): number {
  const { tick, sinceTick, tickRate, timeScale, diagnosis } = view;
  return tick / tickRate + sinceTick / timeScale - diagnosis.lead - rig.now;
}
