import { setTimeout as pause } from 'node:timers/promises';
import { createReplay } from '../../../src/playground/recording/replay';
import { recordPlay } from '../../playground/game/recordPlay';
import { type Figure, figure } from '../measure';

const SHIPS = 30;
const SECONDS = 600;
/** Timed steps back, spread over the recording. */
const STEPS = 60;
/** ms before each step: on the page, too, the collector's own tasks run between two of them. */
const FRAME = 16;

/**
 * Cost of a step back anywhere in a replay of ten minutes with 30 ships, after its keyframes are made, and of the first one
 * alone: ms of CPU time, including the collector's and the compiler's threads, so that other load does not show.
 */
export async function replayFigures(): Promise<readonly Figure[]> {
  const replay = createReplay(recordPlay({ scenario: 'bounce', others: SHIPS - 1, seconds: SECONDS }));
  const from = performance.now();
  replay.prepare(() => false);
  const prepared = performance.now() - from;
  const ticks = await timeSteps('tick');
  return [
    figure('replay-prepare', 'ms', [prepared]),
    figure('replay-first-back', 'ms', ticks.slice(0, 1)),
    figure('replay-tick-back', 'ms', ticks),
    figure('replay-substep-back', 'ms', await timeSteps('substep')),
  ];

  async function timeSteps(unit: 'tick' | 'substep'): Promise<number[]> {
    const times: number[] = [];
    for (let n = 0; n < STEPS; n++) {
      // 7.3 s apart, so that the steps begin at every distance from a keyframe.
      replay.seek(replay.from + ((n * 97.3) % (SECONDS - 10)) + 5);
      replay.step(unit, 1);
      await pause(FRAME);
      const began = process.cpuUsage();
      replay.step(unit, -1);
      const { user, system } = process.cpuUsage(began);
      times.push((user + system) / 1000);
    }
    return times;
  }
}
