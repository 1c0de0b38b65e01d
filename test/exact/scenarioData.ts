/** Landings for both implementations: the scenarios, also as test/service/scenarios.json, and the recorded trajectories. */
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { BODIES, NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../src/dynamics';
import { type Fixture, readFixture, SCENARIOS } from '../../src/scenarios';
import { type CaseInput, caseOf, caseToJson, type ExactCase, withSnakeKeys } from './cases/exactCase';

export const SCENARIO_FILE = fileURLToPath(new URL('../service/scenarios.json', import.meta.url));

/** Every scenario as a case. @throws if one cannot be loaded */
export function scenarioCases(): ExactCase[] {
  return SCENARIOS.map((scenario) => {
    const exact = caseOf(scenario);
    if (!exact.ok) throw new Error(`${scenario.name}: ${exact.reason}`);
    return exact.value;
  });
}

/** The file's contents, one line per scenario. */
export function scenarioText(): string {
  const cases = scenarioCases();
  const lines = SCENARIOS.map(({ about }, i) =>
    JSON.stringify({ about, ...(caseToJson(cases[i]!) as object) }),
  );
  return `[\n${lines.join(',\n')}\n]\n`;
}

/** The world that the service creates if Redis holds none. */
export const WORLD_FILE = fileURLToPath(
  new URL('../../src/service/touchdown_service/world.json', import.meta.url),
);

/** Its contents: the catalogue, in Redis's notation (quaternions w first). */
export function worldText(): string {
  const bodies = BODIES.map(({ attitude: [x, y, z, w], ...body }) => ({ ...body, attitude: [w, x, y, z] }));
  const world = {
    systemId: 'sol',
    epoch: 0,
    terrain: 'hills',
    settings: {},
    shipClasses: SHIP_CLASSES,
    bodies,
  };
  return `${JSON.stringify(withSnakeKeys(world), null, 2)}\n`;
}

const RECORDED = new URL('../parity/fixtures/', import.meta.url);

/** The start and the inputs of each recorded trajectory of test/parity, as cases. @throws when one cannot be read. */
export function recordedCases(): ExactCase[] {
  const names = readdirSync(RECORDED).filter((name) => name.endsWith('.json'));
  return names.sort().map((name) => {
    const fixture = readFixture(readFileSync(new URL(name, RECORDED), 'utf8'));
    if (!fixture.ok) throw new Error(`${name}: ${fixture.reason}`);
    return caseOfFixture(name, fixture.value);
  });
}

function caseOfFixture(name: string, fixture: Fixture): ExactCase {
  const { config, terrain, shipClass, body, initial, states } = fixture;
  let controls = NEUTRAL_CONTROLS;
  const inputs: CaseInput[] = fixture.inputs.map(({ tick, substep, controls: change }) => {
    controls = { ...controls, ...change };
    return { tick: tick - initial.tick, substep, controls };
  });
  const { impactSpeed, ...state } = initial;
  const ship = {
    ...state,
    shipClass: shipClass.name,
    referenceBody: body.name,
    contactImpactSpeed: impactSpeed,
  };
  return {
    name,
    // Differs from the recorded tick in the last bit, but is the same for both implementations.
    tickRate: 1 / fixture.tickSeconds,
    timeScale: 1,
    ticks: states.at(-1)!.tick - initial.tick,
    settings: config,
    terrain,
    shipClass,
    bodies: [body],
    ship,
    inputs,
  };
}
