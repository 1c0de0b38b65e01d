import { DEFAULT_SETTINGS, loadTiming } from '../../dynamics';
import { bodyStateFields, readBodyState } from '../fields/bodyState';
import type { galaxy } from '../generated/codec.js';
import { FINITE, MAX_BODIES, MAX_SHIP_CLASSES, MAX_TICK } from '../limits';
import { refuseLoaded } from '../loaders';
import {
  choiceIn,
  describe,
  type Fields,
  integerIn,
  listIn,
  messageIn,
  nameIn,
  numberIn,
  type Reading,
  refuse,
  refuseRepeats,
  textIn,
} from '../fields/reading';
import type { Hello } from '../records';
import { FIRST_VERSION, matchVersion, PROTOCOL_VERSION } from '../../protocol';
import { readSettings, settingsFields } from '../fields/settings';
import { readShipClass, shipClassFields } from '../fields/shipClass';

/** PREDICTION, Server messages: hello. */
export function readHello(r: Reading, from: Fields): Hello {
  const hello: Hello = {
    kind: 'hello',
    protocolVersion: readProtocolVersion(r, from),
    playerId: textIn(r, from, 'player_id'),
    shipId: textIn(r, from, 'ship_id'),
    settings: messageIn(r, from, 'settings', readSettings),
    shipClasses: listIn(r, from, 'ship_classes', MAX_SHIP_CLASSES, readShipClass),
    bodies: listIn(r, from, 'bodies', MAX_BODIES, readBodyState),
    terrain: nameIn(r, from, 'terrain'),
    tick: integerIn(r, from, 'tick', 0, MAX_TICK),
    ...readTiming(r, from),
    inputGranularity: choiceIn(r, from, 'input_granularity', ['substep', 'tick'], false),
  };
  const named = (list: readonly { readonly name: string }[]) => list.map(({ name }) => name);
  refuseRepeats(r, 'ship_classes', 'name', named(hello.shipClasses));
  refuseRepeats(r, 'bodies', 'name', named(hello.bodies));
  return hello;
}

/** Checked first: a foreign message is refused for its major version, not for a field that changed with it. */
export function readProtocolVersion(r: Reading, from: Fields): string {
  const version = textIn(r, from, 'protocol_version') || FIRST_VERSION;
  if (matchVersion(version) === 'foreign') {
    const [major] = PROTOCOL_VERSION.split('.');
    refuse(r, 'protocol_version', `expected ${major}.x, which this client speaks, got ${describe(version)}`);
  }
  return version;
}

/** Tick rate and time scale within the ranges of DYNAMICS, Time. */
export function readTiming(r: Reading, from: Fields): { tickRate: number; timeScale: number } {
  const tickRate = numberIn(r, from, 'tick_rate', FINITE);
  const timeScale = numberIn(r, from, 'time_scale', FINITE);
  refuseLoaded(r, loadTiming(tickRate, timeScale, DEFAULT_SETTINGS), '');
  return { tickRate, timeScale };
}

export function helloFields(hello: Hello): galaxy.stream.Hello.$Properties {
  return {
    player_id: hello.playerId,
    ship_id: hello.shipId,
    settings: settingsFields(hello.settings),
    ship_classes: hello.shipClasses.map(shipClassFields),
    bodies: hello.bodies.map(bodyStateFields),
    terrain: hello.terrain,
    tick: hello.tick,
    tick_rate: hello.tickRate,
    time_scale: hello.timeScale,
    input_granularity: hello.inputGranularity,
    protocol_version: hello.protocolVersion ?? FIRST_VERSION,
  };
}
