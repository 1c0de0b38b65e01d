import { hullOf, type ShipView, type WorldView } from '../../../src/index';
import { type Era, timeOf, truthAt } from './design/server';
import type { Page } from './page';
import { aboveGround } from './setup';
import { dot, length, minus, plus, type Turn, turned, unit, type Vec } from './design/vectors';

/** One display frame of the player's ship, to be compared once the server has come as far. */
export interface Sample {
  /** True s: of the frame, and of the instant that it draws. */
  readonly t: number;
  readonly drawn: number;
  readonly era: Era;
  readonly tick: number;
  readonly sinceTick: number;
  readonly shipId: string;
  readonly position: Vec;
  readonly nose: Vec;
  readonly shown: string;
  readonly provenance: string;
  /** Drawn instant beyond what newest frame, one send and the lead reach to, s. */
  readonly beyond: number;
  readonly ahead: number;
  /** m of the drawn hull's lowest point above the client's ground. */
  readonly clear: number;
}

export interface Watch {
  readonly samples: Sample[];
  readonly faults: string[];
  readonly each: (view: WorldView) => void;
}

export function watchPage(page: Page): Watch {
  const watch: Watch = {
    samples: [],
    faults: [],
    each(view) {
      if (!isFiniteView(view))
        watch.faults.push(`${page.t.toFixed(2)} s: a number in the view is not finite`);
      if (view.diagnosis.historyBytes > 64e6)
        watch.faults.push(`${page.t.toFixed(2)} s: history of ${view.diagnosis.historyBytes} bytes`);
      if (view.ready && view.own !== null) watch.samples.push(sampleOf(page, view, view.own));
    },
  };
  return watch;
}

function sampleOf(page: Page, view: WorldView, own: ShipView): Sample {
  const { server } = page.setup;
  const { tick, sinceTick } = view;
  const { drift } = server.options;
  const era = eraOf(server.eras, { tick, sinceTick, drift, t: page.t });
  const drawn = timeOf(era, tick, sinceTick, drift);
  // In the server's own time: a stopped server stretches true time under what is drawn already.
  const isOfNewest = server.eras.indexOf(era) + 1 === page.newestEra;
  const ahead = isOfNewest
    ? (tick - page.newestTick) / view.tickRate + sinceTick / view.timeScale
    : Number.NaN;
  return {
    t: page.t,
    drawn,
    era,
    tick,
    sinceTick,
    shipId: own.shipId,
    position: [...own.position] as unknown as Vec,
    nose: turned([...own.attitude] as unknown as Turn, [0, 0, 1]),
    shown: own.shownState,
    provenance: own.provenance,
    ahead,
    beyond: ahead - 1 / server.options.sendRate - view.diagnosis.lead,
    clear: clearOf(page, view, own),
  };
}

/** Of the runs that have this tick, the one that is nearest to the present. */
function eraOf(
  eras: readonly Era[],
  {
    tick,
    sinceTick,
    drift,
    t,
  }: { readonly tick: number; readonly sinceTick: number; readonly drift: number; readonly t: number },
): Era {
  const known = eras.filter(({ ticks, firstTick }) => ticks.length > 0 && tick >= firstTick - 1);
  const off = (era: Era) => Math.abs(timeOf(era, tick, sinceTick, drift) - t);
  return known.reduce((best, era) => (off(era) <= off(best) ? era : best), known[0] ?? eras[0]!);
}

/** Height of the lowest point of the drawn hull and its pressed legs above the client's own ground, m. */
function clearOf(page: Page, view: WorldView, own: ShipView): number {
  const { outline, feet } = hullOf(own.shipClass, own.groundContactOffset);
  const { clientTerrain, server } = page.setup;
  const attitude = [...own.meshAttitude] as unknown as Turn;
  const bodyAttitude = [...view.bodies[own.body]!.attitude] as unknown as Turn;
  const heightOf = (x: number, y: number, z: number): number => {
    const at = plus([...own.meshPosition] as unknown as Vec, turned(attitude, [x, y, z]));
    return aboveGround(clientTerrain, server.body, bodyAttitude, at);
  };
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < outline.length; i += 3)
    least = Math.min(least, heightOf(outline[i]!, outline[i + 1]!, outline[i + 2]!));
  for (let i = 0; i < feet.length; i += 3)
    least = Math.min(least, heightOf(feet[i]!, feet[i + 1]!, feet[i + 2]! + own.legCompression[i / 3]!));
  return least;
}

function isFiniteView(view: WorldView): boolean {
  const { tick, sinceTick, tickRate, timeScale, bodies, ships } = view;
  const numbers = [tick, sinceTick, tickRate, timeScale];
  for (const { position, velocity, attitude } of bodies) numbers.push(...position, ...velocity, ...attitude);
  for (const ship of ships)
    for (const value of Object.values(ship)) {
      if (value instanceof Float64Array) numbers.push(...value);
      else if (typeof value === 'number') numbers.push(value);
    }
  return numbers.every(Number.isFinite);
}

/** Against the truth: metres off, degrees off, and whether the status was another. */
export interface DrawnError {
  readonly metres: number;
  readonly degrees: number;
  readonly isWrong: boolean;
  readonly state: string;
}

export function errorOf(sample: Sample): DrawnError | null {
  const truth = truthAt(sample.era, sample.shipId, sample.tick, sample.sinceTick);
  if (truth === null) return null;
  const nose = turned(truth.attitude, [0, 0, 1]);
  return {
    metres: length(minus(sample.position, truth.position)),
    degrees: (Math.acos(Math.max(-1, Math.min(1, dot(unit(nose), unit(sample.nose))))) * 180) / Math.PI,
    isWrong: sample.shown !== truth.state,
    state: truth.state,
  };
}
