import { GRAVITATIONAL_CONSTANT, type Vec3 } from '../../../../src/dynamics';
import type { ShipView, WorldView } from '../../../../src/prediction';
import type { ShipState } from '../../../../src/wire';
import { CASES, type LiteralCase, USUAL_FLIGHTS } from '../../../prediction/literalServer/cases';
import {
  createLiteralRig,
  type LiteralFlight,
  type LiteralRig,
  literalTruthAt,
} from '../../../prediction/literalServer/literalRig';
import { conjugate, rotate } from '../../../prediction/literalServer/vectors';
import type { LiteralTruth } from '../../../prediction/literalServer/literalServer';
import { SHIP } from '../../../prediction/rig';
import { distance } from '../../../prediction/samples';
import { createForeignBaselines } from './foreignBaselines';
import { type Figure, spread } from '../figure';

/** Ticks and sends per second. */
export const RATES: readonly (readonly [number, number])[] = [
  [50, 10],
  [50, 1],
  [20, 10],
  [20, 1],
];
const SECONDS = 24;
/** Frames after which game time per tick is measured. */
const TIME_KNOWN = 4;

/** The result of one method over the flights of a case. */
export interface Drawn {
  readonly errors: number[];
  /** Errors from the third state of a contact on. */
  readonly settled: number[];
  wrongStatus: number;
  underground: number;
  jump: number;
}

export interface CaseResult {
  readonly ours: Drawn;
  readonly gravity: Drawn;
  readonly behind: Drawn;
  contacts: number;
}

const drawn = (): Drawn => ({ errors: [], settled: [], wrongStatus: 0, underground: 0, jump: 0 });

/** The methods to measure. */
export type Way = 'ours' | 'gravity' | 'behind';
const WAYS: readonly Way[] = ['ours', 'gravity', 'behind'];

const NO_BASELINES = () => ({ gravity: null, behind: null });

/** Flies all flights of a case, drawn `fps` times a second. */
export function flyCase(
  difference: LiteralCase,
  hz: number,
  sends: number,
  ways: readonly Way[] = WAYS,
  fps = 60,
): CaseResult {
  const result: CaseResult = { ours: drawn(), gravity: drawn(), behind: drawn(), contacts: 0 };
  for (const scenario of difference.flights ?? USUAL_FLIGHTS)
    flyForeign({ scenario, hz, sends, difference, fps }, result, ways);
  return result;
}

interface Sample {
  readonly ticks: number;
  readonly ours: Placed;
  readonly gravity: Placed | null;
  readonly behind: Placed | null;
}

export interface Placed {
  readonly position: Vec3;
  readonly state: string;
  /** Depth of the drawn feet below the client's ground, m. */
  readonly underground: number;
}

/** One flight, measured relative to the server's ticks at the view's fraction of a tick. */
export function flyForeign(flight: LiteralFlight, result: CaseResult, ways: readonly Way[] = WAYS): void {
  const rig = createLiteralRig(flight);
  const baselines =
    ways.length > 1
      ? createForeignBaselines(rig, GRAVITATIONAL_CONSTANT)
      : { receive: () => undefined, draw: NO_BASELINES };
  const samples: Sample[] = [];
  const stretch = flight.difference.options.timeScale ?? 1;
  const { fps = 60 } = flight;
  const frames = (fps * SECONDS) / Math.min(stretch, 2);
  const contactTicks: number[] = [];
  let heard = 0;
  for (let i = 0; i < frames; i++) {
    const view = rig.frame((frame) => {
      baselines.receive(frame, rig.now);
      heard += 1;
      if (frame.ships[0]?.shipId === SHIP && isSettling(frame.ships[0], flight.difference))
        contactTicks.push(frame.tick);
    });
    // No frame has the time scale; it is known from the third on. A tick rate that is not sent counts as 1 Hz until it is measured.
    const isKnown = (stretch === 1 || heard >= TIME_KNOWN) && (flight.hz === 1 || view.tickRate !== 1);
    if (!view.ready || view.own === null || !isKnown) continue;
    const ticks = view.tick + view.sinceTick * (view.tickRate / view.timeScale);
    const own = placedOf(view.own, view, rig);
    samples.push({ ticks, ours: own, ...baselines.draw(ticks, rig.now) });
  }
  const third = contactTicks[2] ?? Number.POSITIVE_INFINITY;
  let last: { sample: Sample; truth: LiteralTruth } | null = null;
  let touching = false;
  for (const sample of samples) {
    const truth = literalTruthAt(rig.server, SHIP, sample.ticks);
    if (truth === null) continue;
    // The game deletes it.
    if (truth.state === 'crashed') break;
    const touches = truth.state !== '' && truth.state !== 'crashed';
    if (touches && !touching) result.contacts += 1;
    touching = touches;
    for (const way of ways) {
      const placed = sample[way];
      if (placed !== null)
        measure(result[way], placed, truth, { settled: sample.ticks >= third, shown: 1 / fps });
      const before = last?.sample[way] ?? null;
      if (placed !== null && before !== null) {
        const moved = (k: number) => placed.position[k]! - before.position[k]!;
        const really = (k: number) => truth.position[k]! - last!.truth.position[k]!;
        const jump = Math.hypot(...[0, 1, 2].map((k) => moved(k) - really(k)));
        result[way].jump = Math.max(result[way].jump, jump);
      }
    }
    last = { sample, truth };
  }
}

function isSettling(ship: ShipState, { settlesLanded }: LiteralCase): boolean {
  return settlesLanded === true ? ship.surfaceContactState === 'landed' : ship.landedBodyName !== '';
}

/** `shown`: how long the frame is on the display, s. */
function measure(
  out: Drawn,
  placed: Placed,
  truth: LiteralTruth,
  { settled, shown }: { settled: boolean; shown: number },
): void {
  const error = distance(placed.position, truth.position);
  out.errors.push(error);
  if (settled) out.settled.push(error);
  if (placed.state !== truth.state) out.wrongStatus += shown;
  out.underground = Math.max(out.underground, placed.underground);
}

function placedOf(own: ShipView, view: WorldView, { terrainHeight }: LiteralRig): Placed {
  const { name, radius, attitude } = view.bodies[own.body]!;
  const low = Math.hypot(...own.meshPosition);
  const up = [...own.meshPosition].map((x) => x / low) as unknown as Vec3;
  const [nx, ny, nz] = rotate(conjugate(attitude), up);
  const feet = low - own.shipClass.groundContactOffset + Math.max(...own.legCompression);
  return {
    position: [...own.easedPosition] as unknown as Vec3,
    state: own.crashed ? 'crashed' : own.surfaceContactState,
    underground: Math.max(0, radius + terrainHeight(name, nx, ny, nz) - feet),
  };
}

/** Rows of the section "foreign server". */
export function* foreignFigures(): Generator<Figure> {
  for (const difference of CASES) {
    for (const [hz, sends] of RATES) {
      const { ours, gravity, behind, contacts } = flyCase(difference, hz, sends);
      const name = `foreign server, ${difference.name}, ${hz} Hz sent at ${sends} Hz`;
      const { p50, p95, max } = spread(ours.errors);
      const other = spread(gravity.errors);
      const late = spread(behind.errors);
      const settled = spread(ours.settled).p95;
      const met =
        p50 <= other.p50 + SLACK &&
        p95 <= other.p95 + SLACK &&
        max <= other.max + SLACK &&
        ours.wrongStatus <= gravity.wrongStatus + 0.05 &&
        ours.jump <= gravity.jump + SLACK &&
        (difference.rise === undefined || ours.wrongStatus <= WRONG_STATUS * contacts);
      yield {
        name: `${name}: drawn − server`,
        unit: 'm',
        p50,
        p95,
        max,
        met,
        target:
          difference.rise === undefined
            ? 'no figure worse than gravity-only'
            : `no figure worse than gravity-only, wrong status ≤ ${WRONG_STATUS} s a contact`,
        note:
          `settled p95 ${round(settled)}; wrong status ${round(ours.wrongStatus)} s in ${contacts} contacts, ` +
          `underground ${round(ours.underground)} m, jump ${round(ours.jump)} m; gravity-only ${round(other.p50)}, ` +
          `${round(other.p95)}, ${round(other.max)} m, ${round(gravity.wrongStatus)} s, ${round(gravity.underground)} m, ` +
          `${round(gravity.jump)} m; interpolated ${round(late.p50)}, ${round(late.p95)}, ${round(late.max)} m`,
      };
    }
  }
}

/** s a contact, on another ground. */
const WRONG_STATUS = 0.3;
/** m; smaller differences are invisible. */
const SLACK = 0.01;
const round = (x: number): string => String(Number(x.toPrecision(3)));
