import { type Controls, flatTerrain, NEUTRAL_CONTROLS, TERRAINS } from '../../dynamics';
import { createPredictor, type EventNotice, type Predictor, type WorldView } from '../../prediction';
import {
  findScenario,
  NETWORK_PRESETS,
  type NetworkNumbers,
  type RecordingEntry,
  type RunInput,
  type ScheduledInput,
} from '../../scenarios';
import type { PartialFrame, ServerMessage } from '../../wire';
import { type Baseline, createBaseline } from './baseline';
import type { Choices } from '../panels/choices';
import { createHands, type Hands } from './hands';
import { createPageClock, type PageClock } from './pageClock';
import { createRunHash } from './mission/runHash';
import { type Script, scriptOf } from './script';
import { openTab, TAB_ADDRESS } from '../server/tabLink';
import { type Connection, type ConnectionHandlers, openWorker, type ShipLoss } from '../server/connection';
import type { Operation } from '../server/operation';
import { deferConnection } from '../server/deferred';

/** What the page is told of a live game. */
export interface LiveListeners {
  readonly onState: (text: string) => void;
  /** A new world begins: what was of the old one is gone. `plan`: what the own ship does by itself in it. */
  readonly onWorld: (plan: readonly ScheduledInput[]) => void;
  readonly onRefused: (reason: string) => void;
  readonly onEvent: (notice: EventNotice) => void;
  /** Everything that goes through the predictor, in its order. */
  readonly onEntry: (entry: RecordingEntry) => void;
  /** The own ship was destroyed, and a real server has said so. */
  readonly onLost: (ship: ShipLoss) => void;
  /** The inputs that acted on the own ship, as asked for by { kind: 'run' }. */
  readonly onRun: (inputs: readonly RunInput[]) => void;
  /** The host of a shared world has begun a scenario. */
  readonly onScenario: (scenario: string, terrain: string) => void;
}

/** A game against a server: connection, predictor, hands. */
export interface Live {
  readonly clock: PageClock;
  readonly hands: Hands;
  readonly baseline: Baseline;
  /** receive → advance → view, and what is to be sent goes out. */
  readonly frame: () => WorldView;
  /** The stick was moved: taken at once, however far off the next frame is. */
  readonly steer: () => void;
  /** A new world, as the choices say. */
  readonly begin: (choices: Choices) => void;
  readonly operate: (operation: Operation) => void;
  readonly reconnect: () => void;
  readonly setSpeed: (speed: number) => void;
  /** While true no frame is taken: as in a hidden tab. */
  readonly hold: (held: boolean) => void;
  /** The newest view. */
  readonly view: () => WorldView;
  /** A world has been asked for and has not come yet. */
  readonly isLoading: () => boolean;
  /** Tick and bits of the own ship's last state up to the scenario's end; '' before the first. */
  readonly hash: () => string;
  readonly ended: () => boolean;
  readonly dispose: () => void;
}

/** Delays and stalls of the choices' network. */
export function networkOf(choices: Choices): NetworkNumbers {
  if (choices.network !== 'custom') return NETWORK_PRESETS[choices.network as keyof typeof NETWORK_PRESETS];
  return {
    delay: choices.delay / 1000,
    jitter: choices.jitter / 1000,
    stallShare: choices.stalled / 100,
    stallSeconds: choices.stall / 1000,
    stallRun: 1.5,
  };
}

/** @param program address of the page's own main module, which the worker runs too */
export function createLive(program: string, listeners: LiveListeners): Live {
  const clock = createPageClock(() => performance.now() / 1000);
  const hands = createHands(
    () => view,
    () => TERRAINS[ground] ?? flatTerrain,
  );
  const runHash = createRunHash();
  let ground = '';
  const baseline = createBaseline();
  const inbox: { readonly message: ServerMessage | PartialFrame; readonly at: number }[] = [];
  let script: Script | null = null;
  let predictor = newPredictor();
  let connection: Connection | null = null;
  let address = '';
  let sampledAt = NaN;
  let held = false;
  let isLoading = false;
  let view = predictor.view(clock.now());

  function newPredictor(): Predictor {
    const made = createPredictor({ ownShipId: 'own', plan: script?.plan ?? [] });
    made.onEvent(listeners.onEvent);
    return made;
  }

  const handlers: ConnectionHandlers = {
    onOpen(what) {
      if (what === 'world') {
        isLoading = false;
        forgetWorld();
      }
      listeners.onState('');
    },
    onMessage: (message) => inbox.push({ message, at: clock.now() }),
    onUnusable: (reason) => predictor.refused(reason),
    onClosed: (reason) => listeners.onState(`Connection lost: ${reason}.`),
    onLink: (words) => listeners.onState(words),
    onWelcome(about) {
      const shipId = about['ship_id'] ?? about['shipId'];
      predictor.setOwnShip(typeof shipId === 'string' ? shipId : null);
    },
    onShipGone(shipId, own) {
      predictor.removeShip(shipId, own === null ? 'gone' : 'destroyed');
      if (own !== null) listeners.onLost(own);
    },
    onRefused: listeners.onRefused,
    onRun: listeners.onRun,
    onScenario(scenario, terrain) {
      ground = terrain;
      listeners.onScenario(scenario, terrain);
    },
    onStatus() {
      // The panel reads the predictor's view, which is what a real server's player has.
    },
  };

  function connect(name: string): Connection {
    if (address === '') return openWorker(program, handlers);
    if (!TAB_ADDRESS.test(address)) {
      const given = address;
      return deferConnection(
        import('../server/realServer').then(({ openServer }) => openServer(given, handlers)),
        () => listeners.onState('Part of the page did not load. Check the network and reload.'),
      );
    }
    return openTab(address, { guest: `guest-${Math.random().toString(36).slice(2, 8)}`, name }, handlers);
  }

  function forgetWorld(): void {
    inbox.length = 0;
    predictor = newPredictor();
    baseline.forget();
    hands.reset();
    runHash.begin(script?.lastTick ?? -1);
    listeners.onWorld(script?.plan ?? []);
  }

  function receive(message: ServerMessage | PartialFrame, at: number): void {
    predictor.receive(message, at);
    listeners.onEntry({ kind: 'received', at, message });
    if (message.kind !== 'frame') return;
    baseline.take(message, at);
    runHash.take(message);
  }

  /** What the hands command; null while they have touched nothing of a scenario, and its plan flies. */
  function fly(now: number): Controls | null {
    const seconds = Number.isNaN(sampledAt) ? 0 : now - sampledAt;
    sampledAt = now;
    const commanded = hands.controls(view, now, seconds / clock.speed());
    return commanded === null && script === null ? NEUTRAL_CONTROLS : commanded;
  }

  function advance(now: number): void {
    const controls = fly(now);
    predictor.advance(controls, now);
    listeners.onEntry({ kind: 'advanced', at: now, controls });
  }

  function send(now: number): void {
    for (const message of predictor.takeOutgoing()) {
      connection?.send(message);
      listeners.onEntry({ kind: 'sent', at: now, message });
    }
  }

  return {
    clock,
    hands,
    baseline,
    frame() {
      const now = clock.now();
      if (held) return view;
      for (const { message, at } of inbox.splice(0)) receive(message, at);
      advance(now);
      view = predictor.view(now);
      send(now);
      return view;
    },
    steer() {
      if (held) return;
      const now = clock.now();
      advance(now);
      send(now);
    },
    begin(choices) {
      script = scriptOf(choices);
      ground = choices.terrain === '' ? (findScenario(choices.scenario)?.terrain ?? '') : choices.terrain;
      if (connection === null || choices.server !== address) {
        connection?.dispose();
        address = choices.server;
        forgetWorld();
        connection = connect(choices.pilot);
      }
      isLoading = true;
      clock.setSpeed(choices.slow);
      if (address !== '') {
        script = null;
        return;
      }
      connection.setSpeed(choices.slow);
      const { scenario, body, shipClass, terrain, surfaceNormal, seed, fleet, legacy } = choices;
      const { tickRate, timeScale } = script;
      const network = networkOf(choices);
      connection.operate({
        kind: 'load',
        ...{ scenario, body, shipClass, terrain, surfaceNormal, tickRate, timeScale, network, seed },
        others: fleet,
        pilot: choices.pilot,
        legacy: legacy === 1,
      });
    },
    operate: (operation) => connection?.operate(operation),
    reconnect: () => connection?.reconnect(),
    setSpeed(speed) {
      clock.setSpeed(speed);
      connection?.setSpeed(speed);
    },
    hold(next) {
      held = next;
      if (next) hands.letGo();
    },
    view: () => view,
    isLoading: () => isLoading,
    hash: runHash.text,
    ended: runHash.ended,
    dispose() {
      connection?.dispose();
    },
  };
}
