import { createRig } from '../prediction/rig';
import { type Figure, timed } from './measure';

/** Cost of a predictor in a worker for the page, besides waiting: the copy of each view, with one ship and with 200. */
export function workerFigures(): Figure[] {
  return [1, 200].map((ships) => {
    const rig = createRig({ scenario: 'settle', tickRate: 5, others: ships - 1 });
    rig.fly(3);
    const view = rig.view();
    if (view.ships.length !== ships) throw new Error(`expected ${ships} ships, got ${view.ships.length}`);
    return timed(`view-copied-${ships}`, Math.ceil(400 / ships), 1, (times) => {
      for (let i = 0; i < times; i++) structuredClone(view);
    });
  });
}
