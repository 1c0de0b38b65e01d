import {
  type Controls,
  flatTerrain,
  loadBody,
  loadSettings,
  loadShipClass,
  NEUTRAL_CONTROLS,
  type World,
  TERRAIN_NORMALS,
} from '../../src/dynamics';
import { type Authority, createAuthority, type SpawnOrder } from '../../src/authority';
import {
  createPredictor,
  type EventNotice,
  type Predictor,
  type PredictorOptions,
  type WorldView,
} from '../../src/prediction';
import {
  createLoopbackLink,
  type LoopbackLink,
  fleetOrders,
  type NetworkNumbers,
  NETWORK_PRESETS,
  pilotAt,
  type Scenario,
  SCENARIOS,
  loadScenario,
  type LoadedScenario,
} from '../../src/scenarios';
import {
  type ClientMessage,
  type InputRecord,
  decodeServerMessage,
  encodeClientMessage,
  type ServerMessage,
} from '../../src/wire';
import { type Truth, watch } from './truth';

/** A server, a network and a client on one wall clock, which is an argument: for tests and benchmarks. */
export interface Rig {
  readonly loaded: LoadedScenario;
  readonly exchange: LoopbackLink;
  readonly authority: Authority;
  readonly truth: Truth;
  predictor: Predictor;
  readonly notices: EventNotice[];
  /** Client wall s. */
  now: number;
  readonly view: () => WorldView;
  /** One display frame. */
  readonly frame: (controls?: Controls | null) => WorldView;
  /** As in a hidden tab: messages arrive, but nothing is advanced or drawn. */
  readonly receiveOnly: () => void;
  /** Inputs sent, in order. */
  readonly sentInputs: InputRecord[];
  /** Frames until the wall clock has passed `seconds` more. */
  readonly fly: (seconds: number, each?: (view: WorldView) => void) => void;
  /** Called with the server's messages before the predictor receives them; may change, drop or add some. */
  tamper: (message: ServerMessage) => readonly ServerMessage[];
}

export interface RigOptions {
  readonly scenario: string | Scenario;
  readonly tickRate?: number;
  readonly timeScale?: number;
  readonly network?: NetworkNumbers;
  readonly seed?: number;
  /** The game's own server: no hello, no acknowledgements, no fields 31–34, whole-tick inputs. */
  readonly legacy?: boolean;
  /** Number of other players' ships. */
  readonly others?: number;
  readonly orders?: readonly SpawnOrder[];
  /** Frames a second. */
  readonly hz?: number;
  readonly pilot?: Pilot;
  readonly predictor?: PredictorOptions;
  /** Settings of the server that differ from those it sends. */
  readonly secretSettings?: Scenario['settings'];
  /** Wall s until which a message to the server is held; later messages queue behind it. */
  readonly holdBack?: (message: ClientMessage, now: number) => number;
}

export const ME = 'me';
export const SHIP = 'ship-1';

export function scenarioNamed(name: string): Scenario {
  const found = SCENARIOS.find((scenario) => scenario.name === name);
  if (found === undefined) throw new Error(`no scenario named ${name}`);
  return found;
}

export function value<T>(checked: { ok: true; value: T } | { ok: false; reason: string }): T {
  if (!checked.ok) throw new Error(checked.reason);
  return checked.value;
}

export type Pilot = (game: number) => Controls;

/** The pilot of a scenario with inputs. */
export function pilotOf(loaded: LoadedScenario): Pilot | null {
  return loaded.inputs.length > 0 ? (game) => pilotAt(loaded, game) : null;
}

/** The pilot's controls at the present. Without a pilot no view is made: it costs as much as an advance. */
export function commanded(
  pilot: Pilot | null,
  view: () => WorldView,
  gameTime: (view: WorldView) => number,
): Controls {
  if (pilot === null) return NEUTRAL_CONTROLS;
  const present = view();
  return pilot(present.ready ? gameTime(present) : 0);
}

const gameTimeOf = ({ tick, sinceTick, timeScale, tickRate }: WorldView) =>
  (tick * timeScale) / tickRate + sinceTick;

export function createRig(options: RigOptions): Rig {
  const given = typeof options.scenario === 'string' ? scenarioNamed(options.scenario) : options.scenario;
  const scenario = {
    ...given,
    tickRate: options.tickRate ?? given.tickRate,
    timeScale: options.timeScale ?? given.timeScale,
  };
  const loaded = value(loadScenario(scenario));
  const bodies = [loaded.body];
  const told = scenario.settings;
  const settings = { ...told, ...options.secretSettings };
  const toldSettings = value(loadSettings(told));
  const inner = value(
    createAuthority({
      settings,
      shipClasses: [loaded.shipClass],
      bodies,
      terrain: scenario.terrain,
      terrains: { [scenario.terrain]: loaded.terrainHeight },
      tickRate: scenario.tickRate,
      timeScale: scenario.timeScale,
      legacy: options.legacy ?? false,
    }),
  );
  const world: World = {
    settings: value(loadSettings(settings)),
    shipClasses: [value(loadShipClass(loaded.shipClass))],
    bodies: bodies.map((body) => value(loadBody(body))),
    terrainHeight: loaded.terrainHeight,
    terrainNormals: TERRAIN_NORMALS,
  };
  const own: SpawnOrder = { shipId: SHIP, playerId: ME, name: 'Own', ship: loaded.ship };
  const orders = [own, ...(options.orders ?? fleetOrders(loaded, options.others ?? 0, 7))];
  const truth = watch(inner, world, orders, options.legacy === true ? 'tick' : 'substep');
  const { authority } = truth;
  for (const order of orders) {
    const reason = authority.spawn(order);
    if (reason !== null) throw new Error(reason);
  }

  const network = options.network ?? NETWORK_PRESETS.fourG;
  const exchange = createLoopbackLink(authority, network, options.seed ?? 1, 0);
  const predictor = createPredictor({
    terrains: { [scenario.terrain]: loaded.terrainHeight, flat: flatTerrain },
    ...(options.legacy === true
      ? { ownShipId: SHIP, defaults: { settings: told, terrain: scenario.terrain, bodies } }
      : {}),
    ...options.predictor,
  });
  const step = 1 / (options.hz ?? 60);
  const notices: EventNotice[] = [];
  predictor.onEvent((notice) => notices.push(notice));
  exchange.connect(ME, SHIP, 0);
  const pilot = options.pilot ?? pilotOf(loaded);
  const waiting: { bytes: Uint8Array; leaves: number }[] = [];
  let frames = 0;

  const rig: Rig = {
    loaded,
    exchange,
    authority,
    truth,
    predictor,
    notices,
    now: 0,
    tamper: (message) => [
      message.kind === 'hello' ? { ...message, settings: { ...message.settings, ...toldSettings } } : message,
    ],
    view: () => rig.predictor.view(rig.now),
    sentInputs: [],
    receiveOnly() {
      frames += 1;
      rig.now = frames * step;
      exchange.run(rig.now);
      for (const { bytes } of exchange.deliver(ME, rig.now)) {
        const message = decodeServerMessage(bytes);
        if (!message.ok) rig.predictor.refused(message.reason);
        else for (const tampered of rig.tamper(message.value)) rig.predictor.receive(tampered, rig.now);
      }
    },
    frame(controls) {
      rig.receiveOnly();
      rig.predictor.advance(
        controls === undefined ? commanded(pilot, rig.view, gameTimeOf) : controls,
        rig.now,
      );
      for (const message of rig.predictor.takeOutgoing()) {
        if (message.kind === 'inputs') rig.sentInputs.push(...message.inputs);
        const leaves = Math.max(options.holdBack?.(message, rig.now) ?? rig.now, waiting.at(-1)?.leaves ?? 0);
        waiting.push({ bytes: encodeClientMessage(message), leaves });
      }
      while (waiting.length > 0 && waiting[0]!.leaves <= rig.now)
        exchange.send(ME, waiting.shift()!.bytes, rig.now);
      return rig.view();
    },
    fly(seconds, each) {
      const until = rig.now + seconds;
      while (rig.now < until - 1e-9) {
        const view = rig.frame();
        each?.(view);
      }
    },
  };
  return rig;
}
