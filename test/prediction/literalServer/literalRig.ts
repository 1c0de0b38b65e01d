import { flatTerrain, type TerrainHeight } from '../../../src/dynamics';
import {
  createPredictor,
  type Predictor,
  type PredictorOptions,
  type WorldView,
} from '../../../src/prediction';
import {
  normalNoise,
  createRandom,
  type NetworkNumbers,
  NETWORK_PRESETS,
  type Scenario,
  loadScenario,
  type LoadedScenario,
} from '../../../src/scenarios';
import type { PartialFrame, ServerFrame } from '../../../src/wire';
import { commanded, pilotOf, scenarioNamed, SHIP, value } from '../rig';
import { FAITHFUL, groundOf, type LiteralCase } from './cases';
import { createLiteralServer, FIRST_TICK, type LiteralServer, type LiteralTruth } from './literalServer';
import { plus, scale } from './vectors';

/** The literal server, a network and a client on one wall clock. */
export interface LiteralRig {
  readonly loaded: LoadedScenario;
  readonly server: LiteralServer;
  readonly predictor: Predictor;
  readonly terrainHeight: TerrainHeight;
  /** Client wall s. */
  now: number;
  /** One display frame; `each` sees every frame of the server as it arrives. */
  readonly frame: (each?: (frame: ServerFrame) => void) => WorldView;
}

export interface LiteralFlight {
  readonly scenario: string | Scenario;
  readonly hz: number;
  /** Sends a second, Hz. */
  readonly sends: number;
  readonly difference: LiteralCase;
  readonly network?: NetworkNumbers;
  readonly seed?: number;
  /** Display frames a second; 60 by default. */
  readonly fps?: number;
  readonly predictor?: PredictorOptions;
}

export function createLiteralRig(flight: LiteralFlight): LiteralRig {
  const scenario = typeof flight.scenario === 'string' ? scenarioNamed(flight.scenario) : flight.scenario;
  const loaded = value(loadScenario({ ...scenario, tickRate: flight.hz, timeScale: 1 }));
  const { difference, fps = 60 } = flight;
  const { body, shipClass, terrainHeight } = loaded;
  const server = createLiteralServer(
    { body, ships: shipsOf(loaded, difference) },
    {
      ...FAITHFUL,
      aligned: scenario.settings.touchdownAttitude !== 'kept',
      ...difference.options,
      terrainHeight: groundOf(terrainHeight, difference.rise, { body, site: scenario.site }),
      hz: flight.hz,
      every: Math.round(flight.hz / flight.sends),
    },
  );
  const predictor = createPredictor({
    ownShipId: SHIP,
    terrains: { [scenario.terrain]: terrainHeight, flat: flatTerrain },
    defaults: {
      settings: scenario.settings,
      terrain: scenario.terrain,
      bodies: [body],
      shipClasses: [shipClass],
    },
    ...flight.predictor,
  });
  const missing = createRandom((flight.seed ?? 1) * 77);
  const { delay, jitter } = flight.network ?? NETWORK_PRESETS.broadband;
  const late = createRandom(flight.seed ?? 1);
  let lastAt = 0;
  const waiting: { frame: ServerFrame; at: number }[] = [];
  let ticks = 0;
  let frames = 0;

  function send(frame: ServerFrame, at: number): void {
    if (missing() < (difference.missed ?? 0)) return;
    const parts =
      difference.oneMessagePerShip === true
        ? frame.ships.map((ship) => ({ ...frame, ships: [ship] }))
        : [frame];
    // Messages keep their order on one connection.
    lastAt = Math.max(lastAt, at + Math.max(0, delay + jitter * normalNoise(late)));
    for (const part of parts) waiting.push({ frame: part, at: lastAt });
  }

  const pilot = pilotOf(loaded);
  const gameTime = ({ tick, sinceTick }: WorldView) => (tick - FIRST_TICK) / flight.hz + sinceTick;
  const view = () => predictor.view(rig.now);

  send(server.frame(), 0);
  const rig: LiteralRig = {
    loaded,
    server,
    predictor,
    terrainHeight,
    now: 0,
    frame(each) {
      frames += 1;
      rig.now = frames / fps;
      while ((ticks + 1) / flight.hz <= rig.now) {
        const due = server.tick();
        ticks += 1;
        if (due !== null) send(due, ticks / flight.hz);
      }
      while (waiting.length > 0 && waiting[0]!.at <= rig.now) {
        const { frame } = waiting.shift()!;
        each?.(frame);
        predictor.receive(difference.omitsTickRate === true ? withoutTickRate(frame) : frame, rig.now);
      }
      predictor.advance(commanded(pilot, view, gameTime), rig.now);
      for (const message of predictor.takeOutgoing())
        if (message.kind === 'inputs')
          for (const { controls } of message.inputs) server.control(SHIP, controls);
      return view();
    },
  };
  return rig;
}

/** The frame as a server sends it that does not send its tick rate. */
export function withoutTickRate(frame: ServerFrame): PartialFrame {
  const untimed: { tickRate?: number } & PartialFrame = { ...frame };
  delete untimed.tickRate;
  return untimed;
}

function shipsOf(loaded: LoadedScenario, difference: LiteralCase) {
  const own = { id: SHIP, shipClass: loaded.shipClass, ship: loaded.ship };
  if (difference.oneMessagePerShip !== true) return [own];
  const beside = plus(loaded.ship.relativePosition, [12, 0, 0]);
  return [own, { ...own, id: 'ship-2', ship: { ...loaded.ship, relativePosition: beside } }];
}

/** A ship's true position at a fraction of a tick; null if the server has not simulated it yet. */
export function literalTruthAt(server: LiteralServer, shipId: string, ticks: number): LiteralTruth | null {
  const whole = Math.floor(ticks + 1e-9);
  const before = server.truthAt(shipId, whole);
  const after = server.truthAt(shipId, whole + 1);
  if (before === undefined || after === undefined) return null;
  const share = Math.max(0, ticks - whole);
  const position = plus(scale(before.position, 1 - share), scale(after.position, share));
  return { ...before, position };
}
