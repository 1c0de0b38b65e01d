import {
  accepted,
  ATTITUDE_MODES,
  type Body,
  type BodyMotion,
  type Checked,
  DEFAULT_SETTINGS,
  EVENT_NAMES,
  type Mat3,
  refused,
  type Settings,
  type ShipClass,
  type ShipEventName,
  SURFACE_STATES,
  TERRAINS,
  timingOfTick,
} from '../dynamics';
import { createFields, type Fields, type JsonRecord } from './fields';
import { snakeCase } from './snakeCase';
import type { Fixture, FixtureEvent, FixtureInput, FixtureState, FixtureTerrain } from './fixture';

const MOST_STATES = 200_000;
const MOST_INPUTS = 100_000;
const MOST_EVENTS = 100_000;
/** 0.1 Hz at time scale 100. */
const LONGEST_TICK = 1000;
/** Substeps a fixture may ask for: a minute's work. */
const MOST_SUBSTEPS = 20_000_000;

/** A fixture from its file's text, or a reason that names the field. */
export function readFixture(text: string): Checked<Fixture> {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (error) {
    return refused(`not JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
  const fields = createFields();
  const file = fields.record(json, 'file');
  const fixture: Fixture = {
    name: file['name'] === undefined ? '' : fields.text(file['name'], 'name'),
    about: file['about'] === undefined ? '' : fields.text(file['about'], 'about'),
    tickSeconds: fields.number(file['tick_seconds'], 'tick_seconds'),
    substepsPerTick: fields.whole(file['substeps_per_tick'], 'substeps_per_tick', 1),
    terrain: readTerrain(fields, file['terrain']),
    config: readConfig(fields, file['config']),
    shipClass: readShipClass(fields, fields.record(file['ship_class'], 'ship_class')),
    body: readBody(fields, fields.record(file['body'], 'body')),
    initial: readState(fields, file['initial'], 'initial'),
    inputs: fields.list(file['inputs'], 'inputs', MOST_INPUTS).map((at) => readInput(fields, at)),
    states: fields
      .list(file['states'], 'states', MOST_STATES)
      .map(({ value, path }) => readState(fields, value, path)),
    events: fields.list(file['events'], 'events', MOST_EVENTS).map((at) => readEvent(fields, at)),
  };
  checkTimes(fields, fixture);
  const reason = fields.reason();
  return reason === null ? accepted(fixture) : refused(reason);
}

/** Ticks in order and within reach of a replay, substeps as the law cuts them, the body the only one. */
function checkTimes(fields: Fields, fixture: Fixture): void {
  const { tickSeconds, initial, inputs, states, events, body } = fixture;
  if (!(tickSeconds > 0 && tickSeconds <= LONGEST_TICK)) {
    fields.fault('tick_seconds', `expected more than 0 and at most ${LONGEST_TICK} s, got ${tickSeconds}`);
    return;
  }
  const { substeps } = timingOfTick(tickSeconds);
  if (fixture.substepsPerTick !== substeps)
    fields.fault('substeps_per_tick', `expected ${substeps} for this tick, got ${fixture.substepsPerTick}`);
  if (states.length === 0) fields.fault('states', 'expected at least one');
  const last = states.at(-1)?.tick ?? initial.tick;
  if ((last - initial.tick) * substeps > MOST_SUBSTEPS)
    fields.fault('states', `tick ${last} is more than ${MOST_SUBSTEPS} substeps from the start`);
  inOrder(fields, 'states', states, initial.tick + 1, 1);
  inOrder(fields, 'inputs', inputs, initial.tick, 0);
  inOrder(fields, 'events', events, initial.tick + 1, 0);
  for (const [i, { substep }] of inputs.entries()) {
    if (substep >= substeps)
      fields.fault(`inputs[${i}].substep`, `expected less than ${substeps}, got ${substep}`);
    if (i > 0 && inputs[i - 1]!.tick === inputs[i]!.tick && inputs[i - 1]!.substep > substep)
      fields.fault(`inputs[${i}].substep`, 'expected in the order of time');
  }
  for (const [i, state] of [initial, ...states].entries()) {
    if (state.landedBodyName !== '' && state.landedBodyName !== body.name)
      fields.fault(
        i === 0 ? 'initial.landed_body_name' : `states[${i - 1}].landed_body_name`,
        `expected '' or '${body.name}', got '${state.landedBodyName}'`,
      );
  }
}

function inOrder(
  fields: Fields,
  path: string,
  items: readonly { readonly tick: number }[],
  least: number,
  apart: number,
): void {
  let lowest = least;
  for (const [i, { tick }] of items.entries()) {
    if (tick < lowest)
      fields.fault(`${path}[${i}].tick`, `expected in the order of ticks, at least ${lowest}, got ${tick}`);
    lowest = tick + apart;
  }
}

function readTerrain(fields: Fields, value: unknown): FixtureTerrain {
  const terrain = fields.record(value, 'terrain');
  if (terrain['name'] !== undefined)
    return { name: fields.choice(terrain['name'], 'terrain.name', Object.keys(TERRAINS)) };
  return {
    base: fields.number(terrain['base'], 'terrain.base'),
    amplitude: fields.number(terrain['amplitude'], 'terrain.amplitude'),
    axis: fields.vec3(terrain['axis'], 'terrain.axis'),
  };
}

/** The settings' ranges are the law's to check; here each must be a known name with a value of its type. */
function readConfig(fields: Fields, value: unknown): Partial<Settings> {
  const names = new Map(Object.keys(DEFAULT_SETTINGS).map((name) => [snakeCase(name), name]));
  const settings: Record<string, unknown> = {};
  for (const [key, given] of Object.entries(fields.record(value, 'config'))) {
    const name = names.get(key);
    if (name === undefined) fields.fault(`config.${key}`, 'no such setting');
    else if (name === 'touchdownAttitude')
      settings[name] = fields.choice(given, `config.${key}`, ['aligned', 'kept']);
    else settings[name] = fields.number(given, `config.${key}`);
  }
  return settings;
}

function readShipClass(fields: Fields, given: JsonRecord): ShipClass {
  const number = (key: string) => fields.number(given[key], `ship_class.${key}`);
  const vec3 = (key: string) => fields.vec3(given[key], `ship_class.${key}`);
  const tensor = fields.list(given['inertia_tensor'], 'ship_class.inertia_tensor', 3);
  if (tensor.length !== 3) fields.fault('ship_class.inertia_tensor', 'expected 3 rows of 3 numbers');
  return {
    name: fields.text(given['name'], 'ship_class.name'),
    dryMass: number('dry_mass'),
    fuelCapacity: number('fuel_capacity'),
    inertiaTensor: tensor.map(({ value, path }) => fields.vec3(value, path)) as unknown as Mat3,
    groundContactOffset: number('ground_contact_offset'),
    legRadius: number('leg_radius'),
    mainEngineThrust: number('main_engine_thrust'),
    mainEngineIsp: number('main_engine_isp'),
    rcsThrust: vec3('rcs_thrust'),
    rcsTorque: vec3('rcs_torque'),
    rcsLever: number('rcs_lever'),
    rcsIsp: number('rcs_isp'),
    reactionWheelTorque: vec3('reaction_wheel_torque'),
  };
}

function readBody(fields: Fields, given: JsonRecord): Body & BodyMotion {
  return {
    name: fields.text(given['name'], 'body.name'),
    mass: fields.number(given['mass'], 'body.mass'),
    radius: fields.number(given['radius'], 'body.radius'),
    position: fields.vec3(given['position'], 'body.position'),
    velocity: fields.vec3(given['velocity'], 'body.velocity'),
    attitude: fields.quat(given['attitude'], 'body.attitude'),
    angularVelocity: fields.vec3(given['angular_velocity'], 'body.angular_velocity'),
  };
}

function readState(fields: Fields, value: unknown, path: string): FixtureState {
  const given = fields.record(value, path);
  return {
    tick: fields.whole(given['tick'], `${path}.tick`, 0),
    relativePosition: fields.vec3(given['relative_position'], `${path}.relative_position`),
    relativeVelocity: fields.vec3(given['relative_velocity'], `${path}.relative_velocity`),
    attitude: fields.quat(given['attitude'], `${path}.attitude`),
    angularVelocity: fields.vec3(given['angular_velocity'], `${path}.angular_velocity`),
    fuel: fields.number(given['fuel'], `${path}.fuel`),
    surfaceContactState: fields.choice(
      given['surface_contact_state'],
      `${path}.surface_contact_state`,
      SURFACE_STATES,
    ),
    landedBodyName: fields.text(given['landed_body_name'], `${path}.landed_body_name`),
    impactSpeed: fields.number(given['impact_speed'], `${path}.impact_speed`),
    crashed: fields.flag(given['crashed'], `${path}.crashed`),
  };
}

function readInput(fields: Fields, { value, path }: { value: unknown; path: string }): FixtureInput {
  const given = fields.record(value, path);
  const controls: Record<string, unknown> = {};
  const at = (key: string) => `${path}.${key}`;
  for (const key of Object.keys(given)) {
    const value = given[key];
    if (key === 'thrust_level') controls['thrustLevel'] = fields.number(value, at(key));
    else if (key === 'translation_input') controls['translationInput'] = fields.vec3(value, at(key));
    else if (key === 'rotation_input') controls['rotationInput'] = fields.vec3(value, at(key));
    else if (key === 'attitude_hold') controls['attitudeHold'] = fields.flag(value, at(key));
    else if (key === 'attitude_mode')
      controls['attitudeMode'] = fields.choice(value, at(key), ATTITUDE_MODES);
    else if (key === 'target_attitude') controls['targetAttitude'] = fields.vec4(value, at(key));
    else if (key !== 'tick' && key !== 'substep') fields.fault(at(key), 'no such input');
  }
  return {
    tick: fields.whole(given['tick'], `${path}.tick`, 0),
    substep: given['substep'] === undefined ? 0 : fields.whole(given['substep'], `${path}.substep`, 0),
    controls,
  };
}

const EVENTS = EVENT_NAMES.filter((name): name is ShipEventName => name !== '');

function readEvent(fields: Fields, { value, path }: { value: unknown; path: string }): FixtureEvent {
  const given = fields.record(value, path);
  return {
    tick: fields.whole(given['tick'], `${path}.tick`, 0),
    event: fields.choice(given['event'], `${path}.event`, EVENTS),
  };
}
