import { createReplay } from '../../../src/playground/recording/replay';
import { recordPlay } from '../../playground/game/recordPlay';
import { type Figure, figure } from '../measure';

const SHIPS = 30;
const SECONDS = 600;
/** Steps back that are timed, all over the recording. */
const STEPS = 60;

/**
 * What one step back costs in a replay of ten minutes of 30 ships, anywhere in it, with its keyframes made: ms of processor time,
 * the collector's threads counted, so that other work on the machine does not show.
 */
export function replayFigures(): readonly Figure[] {
  const replay = createReplay(recordPlay({ scenario: 'bounce', others: SHIPS - 1, seconds: SECONDS }));
  const from = performance.now();
  replay.prepare(() => false);
  const prepared = performance.now() - from;
  return [
    figure('replay-prepare', 'ms', [prepared]),
    figure('replay-tick-back', 'ms', timeSteps('tick')),
    figure('replay-substep-back', 'ms', timeSteps('substep')),
  ];

  function timeSteps(unit: 'tick' | 'substep'): number[] {
    return Array.from({ length: STEPS }, (_, n) => {
      // 7.3 s apart, so that the steps begin at every distance from a keyframe.
      replay.seek(replay.from + ((n * 97.3) % (SECONDS - 10)) + 5);
      replay.step(unit, 1);
      const began = process.cpuUsage();
      replay.step(unit, -1);
      const { user, system } = process.cpuUsage(began);
      return (user + system) / 1000;
    });
  }
}
