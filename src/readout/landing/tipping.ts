import { EVENT_DESTROYED, EVENT_LANDED, EVENT_TIPPED } from '../../dynamics';
import type { WorldView } from '../../prediction';
import { createProjection, type Projection, startProjection, stepProjection } from '../flight/projection';
import type { ViewClock } from './viewClock';
import type { Surface } from '../surface';

/** How far a ship in contact is from toppling (HUD, tip margin). */
export interface TipMargin {
  /** While in contact. */
  shown: boolean;
  /** Degrees left before the point of no return; negative past it. */
  degrees: number;
  /** 'tips': simulated ahead under the present controls, the ship tips. 'holds': it does not within HORIZON. */
  outlook: 'steady' | 'working' | 'tips' | 'holds';
  /** Game s until TIPPED; NaN unless outlook is 'tips'. */
  timeToTipped: number;
}

/** Kept from call to call: one simulation ahead at a time, and the last one's answer. */
export interface TippingMemory {
  readonly projection: Projection;
  startedAt: number;
  /** Game s on the readout's clock; Infinity: does not tip; NaN: no answer yet. */
  tipsAt: number;
}

/** Game s: a lander past the point of no return on the Moon takes 7 s to tip, on Phobos minutes; later does not matter. */
const HORIZON = 30;
/** Some 40 µs: a fleet's substep costs about 0.2 µs a ship. */
const SUBSTEPS_A_CALL = 200;
/** rad/s of growing lean from which a ship still within its feet is simulated too. */
const WORTH_A_LOOK = 0.02;

export function createTipMargin(): TipMargin {
  return { shown: false, degrees: 0, outlook: 'steady', timeToTipped: NaN };
}

export function createTippingMemory(): TippingMemory {
  return { projection: createProjection(), startedAt: 0, tipsAt: NaN };
}

/** A steady ship costs no substep, nor does a paused game. */
export function measureTipMargin(
  out: TipMargin,
  memory: TippingMemory,
  surface: Surface,
  view: WorldView,
  { now }: ViewClock,
): void {
  const ship = view.own!;
  const left = surface.noReturn - surface.lean;
  out.shown = true;
  out.degrees = (left * 180) / Math.PI;
  if (left > 0 && surface.tiltRate < WORTH_A_LOOK) {
    forgetTipping(memory);
    out.outlook = 'steady';
    out.timeToTipped = NaN;
    return;
  }
  if (!memory.projection.running && (Number.isNaN(memory.tipsAt) || now > memory.startedAt)) {
    memory.startedAt = now;
    startProjection(memory.projection, ship, view.bodies[ship.body]!, view.settings, ship.controls);
  }
  runAhead(memory);
  out.outlook = Number.isNaN(memory.tipsAt) ? 'working' : memory.tipsAt === Infinity ? 'holds' : 'tips';
  out.timeToTipped = out.outlook === 'tips' ? Math.max(0, memory.tipsAt - now) : NaN;
}

export function forgetTipping(memory: TippingMemory): void {
  memory.projection.running = false;
  memory.tipsAt = NaN;
}

/** Runs until the ship tips, comes to rest, or reaches the horizon. A hop continues: the ship may tip at the next touch. */
function runAhead(memory: TippingMemory): void {
  const { projection } = memory;
  for (let i = 0; i < SUBSTEPS_A_CALL && projection.running; i++) {
    const event = stepProjection(projection);
    if (event === EVENT_TIPPED) {
      memory.tipsAt = memory.startedAt + projection.elapsed;
      projection.running = false;
    } else if (event === EVENT_LANDED || event === EVENT_DESTROYED || projection.elapsed >= HORIZON) {
      memory.tipsAt = Infinity;
      projection.running = false;
    }
  }
}
