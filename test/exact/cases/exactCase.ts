/** A landing as plain data that every implementation can play: scenarios, and cases drawn by a seed. */
import {
  ok,
  type Body,
  type BodyMotion,
  type Result,
  type Controls,
  type Settings,
  type ShipClass,
  type ShipInit,
  type Vec3,
} from '../../../src/dynamics';
import { type Scenario, loadScenario, ticksOf } from '../../../src/scenarios';

/** One ship, its world, its pilot. SI units, frames as in ShipInit. */
export interface ExactCase {
  readonly name: string;
  /** Hz */
  readonly tickRate: number;
  readonly timeScale: number;
  /** Duration of the case. */
  readonly ticks: number;
  readonly settings: Partial<Settings>;
  readonly terrain: CaseTerrain;
  readonly shipClass: ShipClass;
  readonly bodies: readonly (Body & BodyMotion)[];
  readonly ship: ShipInit;
  /** In the order of their time; each holds from the start of its substep on. */
  readonly inputs: readonly CaseInput[];
}

/** A terrain by name, or base + amplitude (n · axis)², m, n in the body's axes. */
export type CaseTerrain =
  { readonly name: string } | { readonly base: number; readonly amplitude: number; readonly axis: Vec3 };

export interface CaseInput {
  readonly tick: number;
  readonly substep: number;
  /** As a client sends them: not clamped, the target not of unit length. */
  readonly controls: Controls;
}

/** A scenario as a case, or the reason why it cannot be loaded. */
export function caseOf(scenario: Scenario): Result<ExactCase> {
  const loaded = loadScenario(scenario);
  if (!loaded.ok) return loaded;
  const { body, shipClass, ship, inputs } = loaded.value;
  const { name, tickRate, timeScale, settings, terrain } = scenario;
  const ticks = ticksOf(loaded.value);
  return ok({
    name,
    tickRate,
    timeScale,
    ticks,
    settings,
    terrain: { name: terrain },
    shipClass,
    bodies: [body],
    ship,
    inputs,
  });
}

/** The same data under the game's names, as src/service/touchdown_service/comparison/cases.py reads it. */
export function caseToJson(exact: ExactCase): unknown {
  return withSnakeKeys(exact);
}

/** Plain data under the game's snake_case names. */
export function withSnakeKeys(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withSnakeKeys);
  if (typeof value !== 'object' || value === null) return value;
  const entries = Object.entries(value).map(([key, held]) => [
    key.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`),
    withSnakeKeys(held),
  ]);
  return Object.fromEntries(entries);
}
