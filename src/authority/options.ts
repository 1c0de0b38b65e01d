import {
  BODY_STRIDE,
  err,
  loadTiming,
  loadWorld,
  ok,
  type Result,
  type Settings,
  type ShipClass,
  type TerrainHeight,
  type Timing,
  type World,
  writeBodyMotion,
} from '../dynamics';
import type { BodyState, InputRecord } from '../wire';

/** The world of an authority, and its protocol with clients. */
export interface AuthorityOptions {
  /** Settings that differ from the defaults. */
  readonly settings?: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  /** The bodies at the first tick; afterwards each moves by its velocity and turns by its angular velocity. */
  readonly bodies: readonly BodyState[];
  /** The terrain's name in the hello, and the key into `terrains`. */
  readonly terrain: string;
  readonly terrains: Readonly<Record<string, TerrainHeight>>;
  /** Hz, 0.1–100. */
  readonly tickRate: number;
  /** 0.1–100. */
  readonly timeScale: number;
  /** Number of the first tick boundary; 0 by default. */
  readonly tick?: number;
  /** 'tick': inputs act only at the start of a tick. 'substep' by default. */
  readonly inputGranularity?: 'substep' | 'tick';
  /** Behaves like the game's own server: no hello, no ShipState fields 31–34, no acknowledgements, whole-tick inputs. */
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
  const reason = invalidTick(options.tick) ?? invalidNames(options);
  if (reason !== null) return err(reason);
  const world = loadWorld({
    settings: options.settings ?? {},
    shipClasses: options.shipClasses,
    bodies: options.bodies,
    terrainHeight: options.terrains[options.terrain]!,
  });
  if (!world.ok) return world;
  const timing = loadTiming(options.tickRate, options.timeScale, world.value.settings);
  if (!timing.ok) return timing;
  const bodies = new Float64Array(options.bodies.length * BODY_STRIDE);
  for (const [i, body] of options.bodies.entries()) {
    const invalid = writeBodyMotion(bodies, i * BODY_STRIDE, body);
    if (invalid !== null) return err(`bodies[${i}] (${body.name}): ${invalid}`);
  }
  return ok({ world: world.value, bodies, timing: timing.value });
}

function invalidTick(tick = 0): string | null {
  if (Number.isSafeInteger(tick) && tick >= 0) return null;
  return `tick: expected a whole number ≥ 0, got ${String(tick)}`;
}

function invalidNames({ shipClasses, bodies, terrain, terrains }: AuthorityOptions): string | null {
  if (!Object.hasOwn(terrains, terrain)) return `terrain: no terrain named ${terrain}`;
  return invalidList('shipClasses', shipClasses, MAX_CLASSES) ?? invalidList('bodies', bodies, MAX_BODIES);
}

function invalidList(field: string, items: readonly { name: string }[], most: number): string | null {
  if (items.length === 0 || items.length > most)
    return `${field}: expected 1 to ${most}, got ${items.length}`;
  const twice = items.findIndex(({ name }, i) => items.findIndex((other) => other.name === name) < i);
  return twice === -1 ? null : `${field}[${twice}]: name: ${items[twice]!.name} appears twice`;
}
