import { EVENT_DESTROYED, EVENT_LANDED, EVENT_TIPPED } from '../../../dynamics';
import type { WorldView } from '../../../prediction';
import { createProjection, type Projection, startProjection, stepProjection } from '../../flight/projection';
import type { TipMargin } from '../tipMargin';
import type { ViewClock } from '../viewClock';

/** Kept from call to call: one simulation ahead at a time, and the last one's answer. */
export interface TippingMemory {
  readonly projection: Projection;
  startedAt: number;
  /** Game s on the readout's clock; Infinity: does not tip; NaN: no answer yet. */
  tipsAt: number;
}

/** Game s: a lander past the point of no return on the Moon takes 7 s to tip, on Phobos minutes; later does not matter. */
const HORIZON = 30;
/** About 40 µs: a fleet's substep costs about 0.2 µs per ship. */
const SUBSTEPS_A_CALL = 200;

export function createTippingMemory(): TippingMemory {
  return { projection: createProjection(), startedAt: NaN, tipsAt: NaN };
}

/** Simulates ahead of a ship that is not steady. A steady ship costs no substep, nor does a paused game. */
export function forecastTipping(
  out: TipMargin,
  memory: TippingMemory,
  view: WorldView,
  { now }: ViewClock,
): void {
  const ship = view.own!;
  if (out.outlook === 'steady') {
    forgetTipping(memory);
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
