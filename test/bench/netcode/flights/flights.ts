import type { WorldView } from '../../../../src/prediction';
import { createRig, type Rig, type RigOptions } from '../../../prediction/rig';
import {
  angleBetween,
  distance,
  type Sample,
  sampleOf,
  type TruePose,
  truthAt,
} from '../../../prediction/samples';

/** The result of one flight, measured at every substep of the server. */
export interface Flight {
  readonly rig: Rig;
  /** One per ship and frame, in order of time. */
  readonly measures: readonly Measure[];
  /** Label minus lead relative to true server time, absolute, s, after the first 5 s. */
  readonly clock: number[];
}

export interface Measure {
  readonly sample: Sample;
  readonly truth: TruePose;
  /** |drawn − server| at the label, m and rad. */
  readonly drawn: number;
  readonly drawnAngle: number;
  /** The same for the prediction, without the offset. */
  readonly predicted: number;
  readonly predictedAngle: number;
}

/** Flies and measures. The true state is known a tick after drawing, so the last second of a flight is not measured. */
export function flyMeasured(
  options: RigOptions,
  seconds: number,
  each?: (rig: Rig, view: WorldView) => void,
): Flight {
  const rig = createRig(options);
  const measures: Measure[] = [];
  const clock: number[] = [];
  const waiting: Sample[] = [];
  let head = 0;
  rig.fly(seconds, (view) => {
    each?.(rig, view);
    if (!view.ready) return;
    for (let i = 0; i < view.ships.length; i++) waiting.push(sampleOf(view, rig.now, i));
    if (rig.now > 5) clock.push(Math.abs(clockError(view, rig)));
    for (; head < waiting.length; head++) {
      const measured = measure(waiting[head]!, rig);
      if (measured === null) break;
      measures.push(measured);
    }
  });
  const { disagreements } = rig.truth;
  if (disagreements > 0) throw new Error(`the truth differs from the authority in ${disagreements} ticks`);
  return { rig, measures, clock };
}

function measure(sample: Sample, rig: Rig): Measure | null {
  const truth = truthAt(rig.truth, sample);
  if (truth === null) return null;
  return {
    sample,
    truth,
    drawn: distance(sample.drawn, truth.position),
    drawnAngle: angleBetween(sample.attitude, truth.attitude),
    predicted: distance(sample.position, truth.position),
    predictedAngle: angleBetween(sample.predictedAttitude, truth.attitude),
  };
}

/** Label of the present minus its lead, server wall s, relative to the wall clock, which server and client share here. */
function clockError(view: WorldView, rig: Rig): number {
  const { tick, sinceTick, tickRate, timeScale, diagnosis } = view;
  return tick / tickRate + sinceTick / timeScale - diagnosis.lead - rig.now;
}

/** All corrections of a client. */
export function correctionsOf({ rig }: Flight): number {
  const { correctionsLateInput, correctionsLostInput, correctionsOtherPilot, correctionsMismatch } =
    rig.view().diagnosis;
  return correctionsLateInput + correctionsLostInput + correctionsOtherPilot + correctionsMismatch;
}
