import {
  accepted,
  beginTick,
  BODY_STRIDE,
  type Checked,
  type Controls,
  endTick,
  EVENT_NAMES,
  loadBody,
  loadControls,
  loadSettings,
  loadShipClass,
  NEUTRAL_CONTROLS,
  NO_EVENT,
  refused,
  SHIP_STRIDE,
  type ShipEventName,
  spawnShip,
  stepWorld,
  type TerrainHeight,
  TERRAINS,
  timingOfTick,
  type World,
  writeBodyMotion,
  writeControls,
} from '../dynamics';
import type { Fixture, FixtureEvent, FixtureTerrain } from './fixture';
import { snakeCase } from './snakeCase';

/** A fixture's world, run tick by tick on the dynamics. */
export interface Replay {
  readonly world: World;
  /** The ship's row at `tick`. */
  readonly ship: Float64Array;
  readonly bodies: Float64Array;
  readonly events: FixtureEvent[];
  tick: number;
  /** Runs to the next tick. */
  readonly step: () => void;
}

interface FullInput {
  readonly tick: number;
  readonly substep: number;
  readonly controls: Controls;
}

/** The fixture at its initial tick; a reason that names the field when the law refuses one. */
export function startReplay(fixture: Fixture): Checked<Replay> {
  const world = loadWorld(fixture);
  if (!world.ok) return world;
  const inputs = loadInputs(fixture);
  if (!inputs.ok) return inputs;
  const { initial, body, shipClass } = fixture;
  const ship = new Float64Array(SHIP_STRIDE);
  const bodies = new Float64Array(BODY_STRIDE);
  const motion = writeBodyMotion(bodies, 0, body);
  if (motion !== null) return refused(`body.${snakeCase(motion)}`);
  const { impactSpeed: contactImpactSpeed } = initial;
  const state = { ...initial, shipClass: shipClass.name, referenceBody: body.name, contactImpactSpeed };
  const reason = spawnShip(ship, 0, state, world.value);
  if (reason !== null) return refused(`initial.${snakeCase(reason)}`);
  return accepted(replayOf(fixture, world.value, inputs.value, { ship, bodies }));
}

function replayOf(
  fixture: Fixture,
  world: World,
  inputs: readonly FullInput[],
  { ship, bodies }: { ship: Float64Array; bodies: Float64Array },
): Replay {
  const timing = timingOfTick(fixture.tickSeconds);
  const reported = new Uint8Array(1);
  let nextInput = 0;

  function applyInputs(tick: number, substep: number): void {
    while (nextInput < inputs.length) {
      const next = inputs[nextInput]!;
      if (next.tick > tick || (next.tick === tick && next.substep > substep)) return;
      writeControls(ship, 0, next.controls);
      nextInput++;
    }
  }

  const replay: Replay = {
    world,
    ship,
    bodies,
    events: [],
    tick: fixture.initial.tick,
    step() {
      beginTick(ship, bodies, world);
      for (let s = 0; s < timing.substeps; s++) {
        applyInputs(replay.tick, s);
        stepWorld(ship, bodies, reported, world, timing.dt);
        if (reported[0] === NO_EVENT) continue;
        const event = EVENT_NAMES[reported[0]!] as ShipEventName;
        replay.events.push({ tick: replay.tick + 1, event });
      }
      endTick(bodies, world, timing);
      replay.tick += 1;
    },
  };
  return replay;
}

function loadWorld({ config, shipClass, body, terrain }: Fixture): Checked<World> {
  const settings = loadSettings(config);
  if (!settings.ok) return refused(`config.${snakeCase(settings.reason)}`);
  const loadedClass = loadShipClass(shipClass);
  if (!loadedClass.ok) return refused(snakeCase(loadedClass.reason));
  const loadedBody = loadBody(body);
  if (!loadedBody.ok) return refused(snakeCase(loadedBody.reason));
  return accepted({
    settings: settings.value,
    shipClasses: [loadedClass.value],
    bodies: [loadedBody.value],
    terrainHeight: terrainOf(terrain),
  });
}

function loadInputs(fixture: Fixture): Checked<FullInput[]> {
  let controls = NEUTRAL_CONTROLS;
  const loaded: FullInput[] = [];
  for (const [i, { tick, substep, controls: change }] of fixture.inputs.entries()) {
    const checked = loadControls({ ...controls, ...change });
    if (!checked.ok) return refused(`inputs[${i}].${snakeCase(checked.reason)}`);
    controls = checked.value;
    loaded.push({ tick, substep, controls });
  }
  return accepted(loaded);
}

function terrainOf(terrain: FixtureTerrain): TerrainHeight {
  if ('name' in terrain) return TERRAINS[terrain.name]!;
  const { base, amplitude, axis } = terrain;
  return (_body, nx, ny, nz) => {
    const along = nx * axis[0] + ny * axis[1] + nz * axis[2];
    return base + amplitude * (along * along);
  };
}
