import { baselines } from './baselines';
import { type Figure, spread } from '../figure';
import { flyMeasured } from './flights';
import { flyOthers } from './pilots';

/** A slower ship counts as at rest, m/s over the ground. */
const MOVING = 0.5;
const OTHERS = 12;
const SECONDS = 42;

/** Other players' ships, drawn by this client and by the methods it replaces, relative to the true state at the same instant. */
export function* fleetFigures(): Generator<Figure> {
  const errors = {
    predicted: [] as number[],
    hold: [] as number[],
    gravity: [] as number[],
    behind: [] as number[],
  };
  for (let seed = 1; seed <= 4; seed++) {
    const drawn = baselines();
    let others: ReturnType<typeof flyOthers> | null = null;
    const flight = flyMeasured({ scenario: 'slide', others: OTHERS, seed }, SECONDS, (rig, view) => {
      if (others === null) {
        others = flyOthers(rig, OTHERS, 1000 * seed);
        const { tamper } = rig;
        rig.tamper = (message) => {
          if (message.kind === 'frame') drawn.receive(message, rig.now);
          return tamper(message);
        };
      }
      others(rig);
      if (view.ready) drawn.draw(view, rig.now);
    });
    for (const { sample, truth, drawn: error } of flight.measures) {
      if (sample.shipId === 'ship-1' || sample.wall < 3 || truth.state === 'crashed') continue;
      if (Math.hypot(...truth.velocity) < MOVING) continue;
      const others = drawn.errors(sample, truth.position);
      if (others === null) continue;
      errors.predicted.push(error);
      errors.hold.push(others.hold);
      errors.gravity.push(others.gravity);
      errors.behind.push(others.behind);
    }
  }
  const note = `${OTHERS} pilots, four flights of ${SECONDS} s, 1 Hz, 4G; ${errors.predicted.length} ship frames`;
  const ours = spread(errors.predicted);
  const names = [
    ['holding the last state', spread(errors.hold)],
    ['gravity-only extrapolation with blending', spread(errors.gravity)],
    ['snapshot interpolation one tick behind', spread(errors.behind)],
  ] as const;
  yield {
    name: 'fleet of pilots: drawn − server',
    unit: 'm',
    ...ours,
    target: 'see the ratios',
    met: true,
    note,
  };
  for (const [name, theirs] of names)
    yield { name: `fleet of pilots, ${name}`, unit: 'm', ...theirs, target: 'baseline', met: true };
  const [hold, gravity] = [names[0][1], names[1][1]];
  yield ratio('fleet of pilots, share of gravity-only extrapolation', ours, gravity, 0.2);
  yield ratio('fleet of pilots, share of holding the last state', ours, hold, 0.1);
}

function ratio(
  name: string,
  ours: { p50: number; p95: number },
  theirs: { p50: number; p95: number },
  most: number,
): Figure {
  const p50 = ours.p50 / theirs.p50;
  const p95 = ours.p95 / theirs.p95;
  return { name, unit: '', p50, p95, target: `p50 and p95 ≤ ${most}`, met: p50 <= most && p95 <= most };
}
