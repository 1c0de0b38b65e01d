import { createPredictor, type Predictor, type WorldView } from '../../prediction';
import { compareRecording, type Recording, type RecordingEntry } from '../../scenarios';
import { type Baseline, createBaseline } from '../game/baseline';

/** A recording being played: the predictor is fed again what it was fed then, so that every moment comes out the same. */
export interface Replay {
  /** Wall seconds of the recording. */
  readonly from: number;
  readonly to: number;
  readonly baseline: Baseline;
  readonly divergence: Divergence;
  /** The view at a time; forward it goes on, backward it begins anew. */
  readonly seek: (at: number) => WorldView;
  readonly position: () => number;
  /** Counts the times it began anew: readouts that remember must begin anew too. */
  readonly generation: () => number;
}

export interface Divergence {
  /** Wall seconds of the recording, or null: the recorded server kept to the law throughout. */
  readonly at: number | null;
  readonly words: string;
}

export function createReplay(recording: Recording): Replay {
  const { entries, header } = recording;
  const from = entries[0]?.at ?? 0;
  const to = entries.at(-1)?.at ?? from;
  const baseline = createBaseline();
  let generation = 0;
  let next = 0;
  let position = from;
  let shownAt = from;
  let predictor = begin();

  function begin(): Predictor {
    next = 0;
    shownAt = from;
    generation++;
    baseline.forget();
    return createPredictor({ ownShipId: header.shipId, plan: header.plan ?? [] });
  }

  function feed(entry: RecordingEntry): void {
    if (entry.kind === 'received') {
      predictor.receive(entry.message, entry.at);
      if (entry.message.kind === 'frame') baseline.take(entry.message, entry.at);
    } else if (entry.kind === 'advanced') {
      predictor.advance(entry.controls, entry.at);
      predictor.view(entry.at);
      predictor.takeOutgoing();
      shownAt = entry.at;
    }
  }

  return {
    from,
    to,
    baseline,
    divergence: findDivergence(recording),
    position: () => position,
    generation: () => generation,
    seek(at) {
      const wanted = Math.min(Math.max(at, from), to);
      if (wanted < position) predictor = begin();
      position = wanted;
      while (next < entries.length && entries[next]!.at <= wanted) feed(entries[next++]!);
      // Between two frames of then there was no picture: the earlier one's stays.
      return predictor.view(shownAt);
    },
  };
}

/** The first tick at which the recorded server left the law. */
function findDivergence(recording: Recording): Divergence {
  const compared = compareRecording(recording);
  if (!compared.ok) return { at: null, words: `Nothing to check against the physics: ${compared.reason}.` };
  const { outOfTolerance, disagreement, statesCompared } = compared.value;
  const first = Math.min(outOfTolerance?.tick ?? Infinity, disagreement?.tick ?? Infinity);
  if (first === Infinity)
    return { at: null, words: `No divergence: ${statesCompared} states match the physics.` };
  const how =
    disagreement?.tick === first ? disagreement.how : `${outOfTolerance?.field ?? 'state'} out of tolerance`;
  const entry = recording.entries.find(
    ({ kind, ...rest }) =>
      kind === 'received' && 'message' in rest && rest.message.kind === 'frame' && rest.message.tick >= first,
  );
  return { at: entry?.at ?? null, words: `First divergence at tick ${first}: ${how}.` };
}
