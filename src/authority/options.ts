import {
  ok,
  type Body,
  BODY_STRIDE,
  type Result,
  loadBody,
  type LoadedBody,
  type LoadedShipClass,
  loadSettings,
  loadShipClass,
  loadTiming,
  err,
  type Settings,
  type ShipClass,
  type TerrainHeight,
  type Timing,
  type World,
  writeBodyMotion,
} from '../dynamics';
import type { BodyState, InputRecord } from '../wire';

/** The world of an authority, and how it talks to clients. */
export interface AuthorityOptions {
  /** Settings that differ from the defaults. */
  readonly settings?: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  /** At the first tick; afterwards each moves by its velocity and turns by its angular velocity. */
  readonly bodies: readonly BodyState[];
  /** The terrain's name in the hello, and the key into `terrains`. */
  readonly terrain: string;
  readonly terrains: Readonly<Record<string, TerrainHeight>>;
  /** Hz, 0.1–100. */
  readonly tickRate: number;
  /** 0.1–100. */
  readonly timeScale: number;
  /** The number of the first tick boundary; 0 by default. */
  readonly tick?: number;
  /** 'tick': inputs act at tick starts alone. 'substep' by default. */
  readonly inputGranularity?: 'substep' | 'tick';
  /** Talks as the game's own server does: no hello, no ShipState fields 31–34, no acknowledgements, whole-tick inputs. */
  readonly legacy?: boolean;
  /** Called when a pilot's input acts on its ship, so that the flight can be replayed. Must not throw. */
  readonly onInput?: (shipId: string, input: Omit<InputRecord, 'seq'>) => void;
}

/** The checked options: the world as constants, the bodies as rows. */
export interface LoadedOptions {
  readonly world: World;
  readonly bodies: Float64Array;
  readonly timing: Timing;
}

const MAX_BODIES = 256;
const MAX_CLASSES = 256;

/** The world an authority simulates, or a reason that names the first invalid field. */
export function loadOptions(options: AuthorityOptions): Result<LoadedOptions> {
  const settings = loadSettings(options.settings ?? {});
  if (!settings.ok) return err(`settings.${settings.reason}`);
  const timing = loadTiming(options.tickRate, options.timeScale, settings.value);
  if (!timing.ok) return timing;
  const tick = options.tick ?? 0;
  if (!Number.isSafeInteger(tick) || tick < 0)
    return err(`tick: expected a whole number ≥ 0, got ${String(tick)}`);
  const shipClasses = loadAll('shipClasses', options.shipClasses, MAX_CLASSES, loadShipClass);
  if (!shipClasses.ok) return shipClasses;
  const bodies = loadAll('bodies', options.bodies, MAX_BODIES, (body: Body) => loadBody(body));
  if (!bodies.ok) return bodies;
  const rows = new Float64Array(options.bodies.length * BODY_STRIDE);
  for (const [i, body] of options.bodies.entries()) {
    const reason = writeBodyMotion(rows, i * BODY_STRIDE, body);
    if (reason !== null) return err(`bodies[${i}] (${body.name}): ${reason}`);
  }
  if (!Object.hasOwn(options.terrains, options.terrain))
    return err(`terrain: no terrain named ${options.terrain}`);
  const world: World = {
    settings: settings.value,
    shipClasses: shipClasses.value,
    bodies: bodies.value,
    terrainHeight: options.terrains[options.terrain]!,
  };
  return ok({ world, bodies: rows, timing: timing.value });
}

function loadAll<Given extends { name: string }, Loaded extends LoadedBody | LoadedShipClass>(
  field: string,
  given: readonly Given[],
  most: number,
  load: (one: Given) => Result<Loaded>,
): Result<readonly Loaded[]> {
  if (given.length === 0 || given.length > most)
    return err(`${field}: expected 1 to ${most}, got ${given.length}`);
  const loaded: Loaded[] = [];
  for (const [i, one] of given.entries()) {
    const checked = load(one);
    if (!checked.ok) return err(`${field}[${i}]: ${checked.reason}`);
    if (loaded.some((other) => other.name === one.name))
      return err(`${field}[${i}]: name: ${one.name} appears twice`);
    loaded.push(checked.value);
  }
  return ok(loaded);
}
