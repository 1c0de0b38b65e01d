import { type Figure, spread } from '../figure';
import { type Flight, flyMeasured, type Measure } from './flights';
import { flyPilot } from './law';
import { flyOthers } from './pilots';
import { angleBetween } from '../../../prediction/samples';

/**
 * The largest frame-to-frame change of the view beyond the true motion, at 60 Hz: relative to the correction being eased, or
 * absolute if that is less. A wrong prediction that is not corrected yet diverges from the truth however it is drawn,
 * so a change counts if the prediction at its end is right: at the correction's frame, and during the easing.
 */
export function* smoothnessFigures(): Generator<Figure> {
  const flights: Flight[] = [];
  for (let seed = 1; seed <= 3; seed++) flights.push(flyPilot(seed, 0.1));
  let others: ReturnType<typeof flyOthers> | null = null;
  flights.push(
    flyMeasured({ scenario: 'slide', others: 12 }, 42, (rig) => {
      others ??= flyOthers(rig, 12, 77);
      others(rig);
    }),
  );
  flights.push(
    flyMeasured({ scenario: 'settle' }, 20, (rig) => {
      if (Math.abs((rig.now % 3) - 1.5) < 1 / 120)
        rig.authority.kick('ship-1', [0.7, -0.4, 1.9], [0.05, 0.1, 0]);
    }),
  );
  const changes = flights.flatMap(changesOf);
  const far = spread(changes.map(({ metres }) => metres * 100));
  const angle = spread(changes.map(({ radians }) => (radians * 180) / Math.PI));
  const share = Math.max(...changes.map((c) => Math.min(c.metres / 0.02, c.metres / (0.08 * c.size))));
  const turn = Math.max(
    ...changes.map((c) => Math.min((c.radians * 180) / Math.PI / 0.5, c.radians / (0.08 * c.turnSize))),
  );
  const note = `late inputs, kicks, other pilots; ${changes.length} frames, largest correction ${Math.max(...changes.map((c) => c.size)).toFixed(2)} m`;
  yield {
    name: 'smoothness: frame-to-frame change',
    unit: 'cm',
    ...far,
    target: 'see the shares',
    met: true,
    note,
  };
  yield { name: 'smoothness: frame-to-frame turn', unit: '°', ...angle, target: 'see the shares', met: true };
  yield {
    name: 'smoothness: largest change as a share of what is allowed (2 cm, or 8 % of the correction)',
    unit: '',
    value: share,
    target: '≤ 1',
    met: share <= 1,
  };
  yield {
    name: 'smoothness: largest turn as a share of what is allowed (0.5°, or 8 % of the correction)',
    unit: '',
    value: turn,
    target: '≤ 1',
    met: turn <= 1,
  };
}

interface Change {
  readonly metres: number;
  readonly radians: number;
  readonly size: number;
  readonly turnSize: number;
}

/** m and rad: the prediction is right. */
const RIGHT = 1e-3;

function changesOf({ measures }: Flight): Change[] {
  const last = new Map<string, { measure: Measure; size: number; turnSize: number }>();
  const changes: Change[] = [];
  for (const measure of measures) {
    const { shipId } = measure.sample;
    const before = last.get(shipId);
    const offset = measure.drawn;
    const began = before === undefined || before.measure.drawn < 1e-6;
    const size = began
      ? Math.max(offset, before?.measure.predicted ?? 0)
      : Math.max(before.size, before.measure.drawn);
    const turnBegan = before === undefined || before.measure.drawnAngle < 1e-6;
    const turnSize = Math.max(measure.drawnAngle, turnBegan ? 0 : before.turnSize);
    last.set(shipId, { measure, size, turnSize });
    if (before === undefined || Math.max(measure.predicted, measure.predictedAngle) > RIGHT) continue;
    changes.push({
      metres: errorChange(before.measure, measure),
      // An aligned touchdown turns the true ship upright at once and the drawn ship smoothly: the visible rotation counts.
      radians: Math.min(
        Math.abs(measure.drawnAngle - before.measure.drawnAngle),
        angleBetween(measure.sample.attitude, before.measure.sample.attitude),
      ),
      size: Math.max(size, 1e-9),
      turnSize: Math.max(turnSize, 1e-9),
    });
  }
  return changes;
}

function errorChange(a: Measure, b: Measure): number {
  let sum = 0;
  for (let k = 0; k < 3; k++) {
    const before = a.sample.drawn[k]! - a.truth.position[k]!;
    const after = b.sample.drawn[k]! - b.truth.position[k]!;
    sum += (after - before) ** 2;
  }
  return Math.sqrt(sum);
}
