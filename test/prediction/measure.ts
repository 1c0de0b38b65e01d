import type { WorldView } from '../../src/prediction';
import type { Rig } from './rig';
import { distance, type Sample, sampleOf, truthAt } from './samples';

/** Errors of a flight's frames, relative to the server's states at their labels. */
export interface Measured {
  frames: number;
  /** |drawn − server|, m. */
  worst: number;
  worstPredicted: number;
  wrongStates: number;
  errors: number[];
}

/** Flies on for `seconds` and measures every frame of every ship that the server has simulated meanwhile. */
export function flyAndMeasure(rig: Rig, seconds: number, each?: (view: WorldView) => void): Measured {
  const measured: Measured = { frames: 0, worst: 0, worstPredicted: 0, wrongStates: 0, errors: [] };
  const waiting: Sample[] = [];
  rig.fly(seconds, (view) => {
    each?.(view);
    if (view.ready) for (let i = 0; i < view.ships.length; i++) waiting.push(sampleOf(view, rig.now, i));
    while (waiting.length > 0) {
      const truth = truthAt(rig.truth, waiting[0]!);
      if (truth === null) break;
      const sample = waiting.shift()!;
      const error = distance(sample.drawn, truth.position);
      measured.frames += 1;
      measured.errors.push(error);
      measured.worst = Math.max(measured.worst, error);
      measured.worstPredicted = Math.max(measured.worstPredicted, distance(sample.position, truth.position));
      if (sample.state !== truth.state) measured.wrongStates += 1;
    }
  });
  if (rig.truth.disagreements > 0) throw new Error('the ground truth differs from the authority');
  return measured;
}

/** Number of corrections so far. */
export function corrections(rig: Rig): number {
  const d = rig.view().diagnosis;
  return d.correctionsLateInput + d.correctionsLostInput + d.correctionsOtherPilot + d.correctionsMismatch;
}

/** Distance of the predicted pose from the server's newest state once the ship is at rest, m. */
export function fromServer(rig: Rig): number {
  const ship = rig.view().own!;
  return distance([...ship.position], [...ship.serverPosition]);
}
