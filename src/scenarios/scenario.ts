import {
  ok,
  BODIES,
  type Body,
  type BodyMotion,
  type Result,
  type Controls,
  loadControls,
  loadSettings,
  loadTiming,
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
} from '../dynamics';
import { type LocalState, type Site, toBodyRelative } from './site';

/** One landing as data: tests, golden hashes, benchmarks and the page run the same. SI units, degrees where said. */
export interface Scenario {
  readonly name: string;
  /** For people. */
  readonly title: string;
  readonly about: string;
  /** A name in BODIES. Alone in its world. */
  readonly body: string;
  /** A name in SHIP_CLASSES. */
  readonly shipClass: string;
  readonly settings: Partial<Settings>;
  /** A name in TERRAINS. */
  readonly terrain: string;
  /** Hz */
  readonly tickRate: number;
  readonly timeScale: number;
  /** Of the class's main engine thrust; 1 unless said. */
  readonly engineShare?: number;
  /** Times the body's own spin; 1 unless said. */
  readonly spinFactor?: number;
  readonly site: Site;
  readonly initial: LocalState & {
    /** 0 … 1 of the fuel capacity. */
    readonly fuelFraction: number;
    readonly surfaceContactState: SurfaceState;
    readonly contactImpactSpeed: number;
  };
  /** In the order of their time. */
  readonly inputs: readonly ScenarioInput[];
  /** Game seconds. */
  readonly duration: number;
  /** The events of the whole duration in their order. */
  readonly expected: readonly ShipEventName[];
}

/** Controls from a moment on; what is absent keeps its value. */
export interface ScenarioInput {
  /** Game seconds since the start: taken to the nearest substep, so that it means the same at every tick rate. */
  readonly at: number;
  readonly controls: Partial<Controls>;
}

/** A scenario's data looked up and checked: what a world is made of. */
export interface StagedScenario {
  readonly scenario: Scenario;
  readonly body: Body & BodyMotion;
  readonly shipClass: ShipClass;
  readonly terrainHeight: TerrainHeight;
  readonly timing: Timing;
  readonly ship: ShipInit;
  readonly inputs: readonly StagedInput[];
}

/** Full controls from the start of a substep. */
export interface StagedInput {
  readonly tick: number;
  readonly substep: number;
  readonly controls: Controls;
}

/** Looks a scenario's names up and places its ship; a reason that names the field when that cannot be done. */
export function stage(scenario: Scenario): Result<StagedScenario> {
  const knownBody = BODIES.find((candidate) => candidate.name === scenario.body);
  if (knownBody === undefined) return err(`body: no body named ${scenario.body}`);
  const knownClass = SHIP_CLASSES.find((candidate) => candidate.name === scenario.shipClass);
  if (knownClass === undefined) return err(`shipClass: no class named ${scenario.shipClass}`);
  const body = spun(knownBody, scenario.spinFactor ?? 1);
  const shipClass = throttled(knownClass, scenario.engineShare ?? 1);
  if (!Object.hasOwn(TERRAINS, scenario.terrain)) return err(`terrain: no terrain named ${scenario.terrain}`);
  const terrainHeight = TERRAINS[scenario.terrain]!;
  const settings = loadSettings(scenario.settings);
  if (!settings.ok) return err(`settings.${settings.reason}`);
  const timing = loadTiming(scenario.tickRate, scenario.timeScale, settings.value);
  if (!timing.ok) return timing;
  const inputs = stageInputs(scenario.inputs, timing.value);
  if (!inputs.ok) return inputs;
  const { initial, site } = scenario;
  const fuel = initial.fuelFraction * shipClass.fuelCapacity;
  const ship = toBodyRelative(initial, { ...initial, shipClass, fuel }, { body, site, terrainHeight });
  return ok({
    scenario,
    body,
    shipClass,
    terrainHeight,
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

/** The whole ticks that hold a scenario's duration. */
export function ticksOf({ scenario, timing }: StagedScenario): number {
  return Math.ceil(scenario.duration / timing.tickSeconds - 1e-9);
}

/** The controls a scenario's pilot gives at `seconds` of game time since its start; neutral before the first input. */
export function pilotAt({ scenario, inputs }: StagedScenario, seconds: number): Controls {
  let controls = NEUTRAL_CONTROLS;
  for (const [i, input] of scenario.inputs.entries()) {
    if (input.at > seconds) break;
    controls = inputs[i]!.controls;
  }
  return controls;
}

function stageInputs(inputs: readonly ScenarioInput[], timing: Timing): Result<StagedInput[]> {
  const staged: StagedInput[] = [];
  let controls = NEUTRAL_CONTROLS;
  for (const [i, input] of inputs.entries()) {
    const checked = loadControls({ ...controls, ...input.controls });
    if (!checked.ok) return err(`inputs[${i}].${checked.reason}`);
    if (!(input.at >= (inputs[i - 1]?.at ?? 0)))
      return err(`inputs[${i}].at: expected ≥ 0 and in the order of time, got ${input.at}`);
    controls = checked.value;
    const substeps = Math.round(input.at / timing.dt);
    staged.push({
      tick: Math.floor(substeps / timing.substeps),
      substep: substeps % timing.substeps,
      controls,
    });
  }
  return ok(staged);
}
