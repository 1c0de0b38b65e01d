import {
  ok,
  BODIES,
  type Body,
  type BodyMotion,
  type Result,
  type Controls,
  loadControls,
  loadTiming,
  loadWorld,
  NEUTRAL_CONTROLS,
  err,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  type ShipEventName,
  type ShipInit,
  type SurfaceState,
  type TerrainHeight,
  TERRAINS,
  type Timing,
  type World,
} from '../dynamics';
import type { ScheduledInput } from './runTick';
import { type LocalState, type Site, toBodyRelative } from './site';

/** One landing as data, run by tests, golden hashes, benchmarks and the page alike. SI units; angles in degrees. */
export interface Scenario {
  readonly name: string;
  /** For display. */
  readonly title: string;
  readonly about: string;
  /** A name in BODIES. It is the only body of its world. */
  readonly body: string;
  /** A name in SHIP_CLASSES. */
  readonly shipClass: string;
  readonly settings: Partial<Settings>;
  /** A name in TERRAINS. */
  readonly terrain: string;
  /** Hz */
  readonly tickRate: number;
  readonly timeScale: number;
  /** Share of the class's main engine thrust; 1 by default. */
  readonly engineShare?: number;
  /** Factor on the body's spin; 1 by default. */
  readonly spinFactor?: number;
  readonly site: Site;
  readonly initial: LocalState & {
    /** 0 … 1 of the fuel capacity. */
    readonly fuelFraction: number;
    readonly surfaceContactState: SurfaceState;
    readonly contactImpactSpeed: number;
  };
  /** Ascending in time. */
  readonly inputs: readonly ScenarioInput[];
  /** Game seconds. */
  readonly duration: number;
  /** All events of the duration, in order. */
  readonly expected: readonly ShipEventName[];
}

/** Controls from an instant on; absent ones keep their value. */
export interface ScenarioInput {
  /** Game seconds since the start, rounded to the nearest substep, so that it means the same at every tick rate. */
  readonly at: number;
  readonly controls: Partial<Controls>;
}

/** A scenario with its names resolved and its data checked. */
export interface LoadedScenario {
  readonly scenario: Scenario;
  readonly body: Body & BodyMotion;
  readonly shipClass: ShipClass;
  readonly terrainHeight: TerrainHeight;
  /** Its settings, the one class and the one body, with their constants. */
  readonly world: World;
  readonly timing: Timing;
  readonly ship: ShipInit;
  readonly inputs: readonly ScheduledInput[];
}

/** Resolves a scenario's names and places its ship, or returns a reason that names the field. */
export function loadScenario(scenario: Scenario): Result<LoadedScenario> {
  const knownBody = BODIES.find((candidate) => candidate.name === scenario.body);
  if (knownBody === undefined) return err(`body: no body named ${scenario.body}`);
  const knownClass = SHIP_CLASSES.find((candidate) => candidate.name === scenario.shipClass);
  if (knownClass === undefined) return err(`shipClass: no class named ${scenario.shipClass}`);
  const body = spun(knownBody, scenario.spinFactor ?? 1);
  const shipClass = throttled(knownClass, scenario.engineShare ?? 1);
  if (!Object.hasOwn(TERRAINS, scenario.terrain)) return err(`terrain: no terrain named ${scenario.terrain}`);
  const terrainHeight = TERRAINS[scenario.terrain]!;
  const { settings } = scenario;
  const world = loadWorld({ settings, shipClasses: [shipClass], bodies: [body], terrainHeight });
  if (!world.ok) return world;
  const timing = loadTiming(scenario.tickRate, scenario.timeScale, world.value.settings);
  if (!timing.ok) return timing;
  const inputs = loadInputs(scenario.inputs, timing.value);
  if (!inputs.ok) return inputs;
  const { initial, site } = scenario;
  const fuel = initial.fuelFraction * shipClass.fuelCapacity;
  const ship = toBodyRelative(initial, { ...initial, shipClass, fuel }, { body, site, terrainHeight });
  return ok({
    scenario,
    body,
    shipClass,
    terrainHeight,
    world: world.value,
    timing: timing.value,
    ship,
    inputs: inputs.value,
  });
}

function spun(body: Body & BodyMotion, factor: number): Body & BodyMotion {
  if (factor === 1) return body;
  const [x, y, z] = body.angularVelocity;
  return { ...body, angularVelocity: [x * factor, y * factor, z * factor] };
}

function throttled(shipClass: ShipClass, share: number): ShipClass {
  return share === 1 ? shipClass : { ...shipClass, mainEngineThrust: shipClass.mainEngineThrust * share };
}

/** The number of ticks that cover a scenario's duration. */
export function ticksOf({ scenario, timing }: LoadedScenario): number {
  return Math.ceil(scenario.duration / timing.tickSeconds - 1e-9);
}

/** The scenario's controls at `seconds` of game time since its start; neutral before the first input. */
export function pilotAt({ scenario, inputs }: LoadedScenario, seconds: number): Controls {
  let controls = NEUTRAL_CONTROLS;
  for (const [i, input] of scenario.inputs.entries()) {
    if (input.at > seconds) break;
    controls = inputs[i]!.controls;
  }
  return controls;
}

function loadInputs(inputs: readonly ScenarioInput[], timing: Timing): Result<ScheduledInput[]> {
  const loaded: ScheduledInput[] = [];
  let controls = NEUTRAL_CONTROLS;
  for (const [i, input] of inputs.entries()) {
    const checked = loadControls({ ...controls, ...input.controls });
    if (!checked.ok) return err(`inputs[${i}].${checked.reason}`);
    if (!(input.at >= (inputs[i - 1]?.at ?? 0)))
      return err(`inputs[${i}].at: expected ≥ 0 and ascending, got ${input.at}`);
    controls = checked.value;
    const substeps = Math.round(input.at / timing.dt);
    loaded.push({
      tick: Math.floor(substeps / timing.substeps),
      substep: substeps % timing.substeps,
      controls,
    });
  }
  return ok(loaded);
}
