import type { Controls } from '../../../dynamics';
import type { WorldView } from '../../../prediction';
import type { PendingMessage } from '../../../wire';
import { findScenario, NETWORK_PRESETS, type NetworkNumbers } from '../../../scenarios';
import type { Choices } from '../../panels/choices';
import type { Connection, ConnectionHandlers } from '../../server/connection';
import { deferConnection } from '../../server/deferred';
import type { LoadOperation, Operation } from '../../server/operation';
import { isRealServer, TAB_ADDRESS } from '../../server/tabAddress';
import type { Baseline } from './baseline';
import type { FlightControls } from '../flight/flightControls';
import { createLiveState, forgetWorld, type LiveListeners, type LiveState, noteMessage } from './liveState';
import type { PageClock } from './pageClock';
import { type Script, scriptOf } from './script';

/** A game against a server: connection, predictor, flight controls. */
export interface Live {
  readonly clock: PageClock;
  readonly flightControls: FlightControls;
  readonly baseline: Baseline;
  /** advance → view, and sends outgoing messages. */
  readonly frame: () => WorldView;
  /** A stick was moved: samples it at once, without waiting for the next frame. */
  readonly steer: () => void;
  /** Begins a new world by the choices. */
  readonly begin: (choices: Choices) => void;
  readonly operate: (operation: Operation) => void;
  readonly reconnect: () => void;
  readonly setSpeed: (speed: number) => void;
  /** While true no frame is taken: as in a hidden tab. */
  readonly suspend: (held: boolean) => void;
  /** The newest view. */
  readonly view: () => WorldView;
  /** A world has been requested and has not arrived yet. */
  readonly isLoading: () => boolean;
  /** Tick and bits of the last state of the player's ship up to the scenario's end; '' before the first. */
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

/** Of the link to the server, where it differs. */
export function upNetworkOf(choices: Choices): NetworkNumbers | undefined {
  const { network, upDelay, upJitter, upStalled } = choices;
  if (network !== 'custom' || (upDelay === '' && upJitter === '' && upStalled === '')) return undefined;
  const { delay, jitter, stalled } = choices;
  return networkOf({
    ...choices,
    delay: upDelay === '' ? delay : upDelay,
    jitter: upJitter === '' ? jitter : upJitter,
    stalled: upStalled === '' ? stalled : upStalled,
  });
}

/** @param program address of the page's own main module, which the worker runs too; `worker` runs it already, if it is not null */
export function createLive(program: string, listeners: LiveListeners, worker: Worker | null = null): Live {
  const state = createLiveState(program, listeners, worker);
  const { clock, flightControls, baseline } = state;
  return {
    clock,
    flightControls,
    baseline,
    frame: () => (state.isHeld ? state.view : takeFrame(state, clock.now())),
    steer() {
      if (state.isHeld) return;
      const now = clock.now();
      advance(state, now);
      send(state, now);
    },
    begin: (choices) => beginWorld(state, choices),
    operate: (operation) => state.connection?.operate(operation),
    reconnect: () => state.connection?.reconnect(),
    setSpeed(speed) {
      clock.setSpeed(speed);
      state.connection?.setSpeed(speed);
    },
    suspend(held) {
      state.isHeld = held;
      state.pace.stop();
      if (held) flightControls.releaseAll();
    },
    view: () => state.view,
    isLoading: () => state.isLoading,
    hash: () => state.runHash.text(),
    ended: () => state.runHash.ended(),
    dispose() {
      state.pace.stop();
      state.connection?.dispose();
    },
  };
}

function takeFrame(state: LiveState, now: number): WorldView {
  advance(state, now);
  state.view = state.predictor.view(now);
  send(state, now);
  // The autopilot continues even if the next frame is late.
  if (state.flightControls.autopilot.isOn()) state.pace.expect(() => takeFrame(state, state.clock.now()));
  else state.pace.stop();
  return state.view;
}

/** The pilot's controls; null until the pilot touches anything: a scenario's plan flies, or the server's own controls apply. */
function fly(state: LiveState, now: number): Controls | null {
  const seconds = Number.isNaN(state.sampledAt) ? 0 : now - state.sampledAt;
  state.sampledAt = now;
  return state.flightControls.sample(state.view, now, seconds / state.clock.speed());
}

function advance(state: LiveState, now: number): void {
  const controls = fly(state, now);
  state.predictor.advance(controls, now);
  state.listeners.onEntry({ kind: 'advanced', at: now, controls });
}

function send(state: LiveState, now: number): void {
  for (const message of state.predictor.takeOutgoing()) {
    state.connection?.send(message);
    state.listeners.onEntry({ kind: 'sent', at: now, message });
  }
}

/** Other ships up to which a superseded frame is cheap to decode. */
const FEW = 10;

function beginWorld(state: LiveState, choices: Choices): void {
  const script = scriptOf(choices);
  state.script = script;
  state.ground = choices.terrain === '' ? (findScenario(choices.scenario)?.terrain ?? '') : choices.terrain;
  // A guest joins under its new name.
  const isRenamed = TAB_ADDRESS.test(choices.server) && choices.pilot !== state.pilot;
  if (state.connection === null || choices.server !== state.address || isRenamed) {
    state.connection?.dispose();
    state.address = choices.server;
    state.pilot = choices.pilot;
    forgetWorld(state);
    state.connection = connect(state, choices.pilot);
  }
  state.isLoading = true;
  state.hasFleet = choices.fleet > FEW;
  state.clock.setSpeed(choices.slow);
  if (state.address !== '') {
    state.script = null;
    return;
  }
  state.connection.setSpeed(choices.slow);
  state.connection.operate(loadOf(choices, script));
}

function loadOf(choices: Choices, { plan, tickRate, timeScale }: Script): LoadOperation {
  const { scenario, body, shipClass, terrain, surfaceNormal, seed, fleet, pilot, legacy } = choices;
  const up = upNetworkOf(choices);
  return {
    kind: 'load',
    scenario,
    body,
    shipClass,
    terrain,
    surfaceNormal,
    tickRate,
    timeScale,
    seed,
    pilot,
    network: networkOf(choices),
    ...(up !== undefined && { upNetwork: up }),
    ...(choices.flight !== '' && { plan }),
    others: fleet,
    legacy: legacy === 1,
  };
}

function connect(state: LiveState, name: string): Connection {
  const { address, listeners } = state;
  const handlers = handlersOf(state);
  if (address === '') return state.openBuiltIn(handlers);
  return deferConnection(openRemote(address, name, handlers), () =>
    listeners.onState('Part of the page did not load. Check the network and reload.'),
  );
}

/** Another tab's world or a real server: their code is loaded then. */
async function openRemote(address: string, name: string, handlers: ConnectionHandlers): Promise<Connection> {
  if (isRealServer(address)) return (await import('../../server/realServer')).openServer(address, handlers);
  const { openTab } = await import('../../server/tabLink');
  const guest = `guest-${Math.random().toString(36).slice(2, 8)}`;
  return openTab(address, { guest, name }, handlers);
}

/** Until a scenario's end its states are hashed, on a slow display too; those of a fleet would cost too much to decode. */
function hashSuperseded({ runHash, hasFleet }: LiveState, message: PendingMessage): void {
  if (hasFleet || runHash.ended()) return;
  const decoded = message.decode();
  if (decoded.ok && decoded.value.kind === 'frame') runHash.take(decoded.value);
}

function handlersOf(state: LiveState): ConnectionHandlers {
  const { listeners, clock, tap } = state;
  return {
    onOpen(what) {
      if (what === 'world') {
        state.isLoading = false;
        forgetWorld(state);
      }
      listeners.onState('');
    },
    onPending(message, bytes) {
      const at = clock.now();
      const tapped = tap.wrap(
        message,
        (taken, isAsSent) => noteMessage(state, taken, at, isAsSent ? bytes : undefined),
        () => hashSuperseded(state, message),
      );
      state.predictor.receivePending(tapped, at);
    },
    onFrame(frame) {
      const at = clock.now();
      state.predictor.receive(frame, at);
      noteMessage(state, frame, at);
    },
    onClosed: (reason) => listeners.onState(`Connection lost: ${reason}.`),
    onLink: (words) => listeners.onState(words),
    onWelcome(about) {
      const shipId = about['ship_id'] ?? about['shipId'];
      state.predictor.setOwnShip(typeof shipId === 'string' ? shipId : null);
    },
    onShipGone(shipId, own) {
      state.predictor.removeShip(shipId, own === null ? 'gone' : 'destroyed');
      if (own !== null) listeners.onLost(own);
    },
    onRefused: listeners.onRefused,
    onRun: listeners.onRun,
    onScenario(scenario, terrain) {
      state.ground = terrain;
      listeners.onScenario(scenario, terrain);
    },
  };
}
