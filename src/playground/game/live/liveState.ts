import { flatTerrain, TERRAINS } from '../../../dynamics';
import { createPredictor, type EventNotice, type Predictor, type WorldView } from '../../../prediction';
import type { RecordingEntry, RunInput, ScheduledInput } from '../../../scenarios';
import type { PartialFrame, ServerMessage } from '../../../wire';
import { type Connection, type ConnectionHandlers, openWorker, type ShipLoss } from '../../server/connection';
import { type Baseline, createBaseline } from './baseline';
import { createFlightControls, type FlightControls } from '../flight/flightControls';
import { createRunHash, type RunHash } from '../mission/runHash';
import { createPageClock, type PageClock } from './pageClock';
import { createPace, type Pace } from './pace';
import { createPendingTap, type PendingTap } from './pendingTap';
import type { Script } from './script';

/** Reports of a live game to the page. */
export interface LiveListeners {
  readonly onState: (text: string) => void;
  /** A new world begins; the old one is gone. `plan`: scheduled inputs of the player's ship in it. */
  readonly onWorld: (plan: readonly ScheduledInput[]) => void;
  readonly onRefused: (reason: string) => void;
  readonly onEvent: (notice: EventNotice) => void;
  /** Everything that goes through the predictor, in its order; `bytes`: of a message that is recorded as it was sent. */
  readonly onEntry: (entry: RecordingEntry, bytes?: Uint8Array) => void;
  /** A real server reports that the player's ship was destroyed. */
  readonly onLost: (ship: ShipLoss) => void;
  /** The inputs that acted on the player's ship, as requested by { kind: 'run' }. */
  readonly onRun: (inputs: readonly RunInput[]) => void;
  /** The host of a shared world has begun a scenario. */
  readonly onScenario: (scenario: string, terrain: string) => void;
}

/** State of a live game between frames. */
export interface LiveState {
  /** Opens the built-in server. */
  readonly openBuiltIn: (handlers: ConnectionHandlers) => Connection;
  readonly listeners: LiveListeners;
  readonly clock: PageClock;
  readonly flightControls: FlightControls;
  readonly baseline: Baseline;
  readonly tap: PendingTap;
  readonly pace: Pace;
  runHash: RunHash;
  predictor: Predictor;
  connection: Connection | null;
  /** Of the present connection; '' is the built-in server. */
  address: string;
  /** The pilot's name when it connected. */
  pilot: string;
  /** null: the ship has no scheduled inputs. */
  script: Script | null;
  /** Name of the present terrain. */
  ground: string;
  /** Wall s of the page's clock of the last sample of the controls; NaN before. */
  sampledAt: number;
  /** While true no frame is taken, as in a hidden tab. */
  isHeld: boolean;
  /** A world has been requested and has not arrived yet. */
  isLoading: boolean;
  /** Many other ships fly in this world. */
  hasFleet: boolean;
  view: WorldView;
}

export function createLiveState(program: string, listeners: LiveListeners, worker: Worker | null): LiveState {
  const clock = createPageClock(() => performance.now() / 1000);
  const predictor = newPredictor(null, listeners);
  const state: LiveState = {
    openBuiltIn: builtIn(program, worker),
    listeners,
    clock,
    flightControls: createFlightControls(
      () => state.view,
      () => TERRAINS[state.ground] ?? flatTerrain,
    ),
    baseline: createBaseline(),
    runHash: createRunHash(),
    tap: createPendingTap(),
    pace: createPace(),
    predictor,
    connection: null,
    address: '',
    pilot: '',
    script: null,
    ground: '',
    sampledAt: NaN,
    isHeld: false,
    isLoading: false,
    hasFleet: false,
    view: predictor.view(clock.now()),
  };
  return state;
}

/** Opens the built-in server with the worker that runs already, the first time. */
function builtIn(program: string, worker: Worker | null): LiveState['openBuiltIn'] {
  let begun = worker;
  return (handlers) => {
    const connection = openWorker(program, handlers, begun);
    begun = null;
    return connection;
  };
}

function newPredictor(script: Script | null, { onEvent }: LiveListeners): Predictor {
  const predictor = createPredictor({ ownShipId: 'own', plan: script?.plan ?? [] });
  predictor.onEvent(onEvent);
  return predictor;
}

/** Begins a new world: clears the state of the old one. */
export function forgetWorld(state: LiveState): void {
  const { script, listeners } = state;
  state.tap.clear();
  state.predictor = newPredictor(script, listeners);
  state.baseline.forget();
  state.flightControls.reset();
  state.runHash = createRunHash(script?.lastTick);
  listeners.onWorld(script?.plan ?? []);
}

/** Notes a message that the predictor has just taken; `at`: page clock s of its arrival. */
export function noteMessage(
  state: LiveState,
  message: ServerMessage | PartialFrame,
  at: number,
  bytes?: Uint8Array,
): void {
  state.listeners.onEntry({ kind: 'received', at, message }, bytes);
  if (message.kind !== 'frame') return;
  state.baseline.take(message, at);
  state.runHash.take(message);
}
