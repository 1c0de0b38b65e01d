import { serialize } from 'node:v8';
import { createRig } from '../prediction/rig';
import { type Figure, timed } from './measure';

/** The page's cost of a predictor in a worker, besides the latency: the copy of each view and its size, with one ship and with 200. */
export function workerFigures(): Figure[] {
  return [1, 200].flatMap((ships) => {
    const rig = createRig({ scenario: 'settle', tickRate: 5, others: ships - 1 });
    rig.fly(3);
    const view = rig.view();
    if (view.ships.length !== ships) throw new Error(`expected ${ships} ships, got ${view.ships.length}`);
    const bytes = serialize(view).length;
    const copied = timed(`view-copied-${ships}`, Math.ceil(400 / ships), 1, (times) => {
      for (let i = 0; i < times; i++) structuredClone(view);
    });
    return [copied, { name: `view-bytes-${ships}`, unit: 'B', median: bytes, min: bytes, max: bytes }];
  });
}
