import { WebSocket } from 'ws';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { openServer } from '../../src/playground/server/realServer';
import {
  createPredictor,
  type EventNotice,
  type Predictor,
  type PredictorOptions,
  type WorldView,
} from '../../src/prediction';
import type { PartialFrame } from '../../src/wire';

/** A page without a picture: link, predictor and sixty frames per second, on the machine's clock. */
export interface LivePilot {
  readonly predictor: Predictor;
  readonly view: () => WorldView;
  readonly frames: () => readonly PartialFrame[];
  readonly notices: readonly EventNotice[];
  /** The link's status texts, in order. */
  readonly words: readonly string[];
  readonly trouble: readonly string[];
  /** Calls `look` after each drawn frame until it returns true. */
  readonly fly: (look: (view: WorldView, now: number) => boolean) => Promise<void>;
  readonly dispose: () => void;
}

const FRAME = 1000 / 60;
/** Server frames kept: one flight. */
const KEPT = 4000;

/** Like a browser's WebSocket: an error only closes it. */
class PageSocket extends WebSocket {
  constructor(address: string) {
    super(address);
    this.on('error', () => undefined);
  }
}

export function startPilot(address: string, options: PredictorOptions = {}): LivePilot {
  (globalThis as { WebSocket: unknown }).WebSocket = PageSocket;
  const now = () => performance.now() / 1000;
  const predictor = createPredictor(options);
  const notices: EventNotice[] = [];
  predictor.onEvent((notice) => notices.push(notice));
  const frames: PartialFrame[] = [];
  const words: string[] = [];
  const trouble: string[] = [];
  const take = (frame: PartialFrame) => {
    predictor.receive(frame, now());
    frames.push(frame);
    if (frames.length > KEPT) frames.shift();
  };
  const link = openServer(address, {
    onOpen: () => undefined,
    onPending(message) {
      const decoded = message.decode();
      if (!decoded.ok) trouble.push(decoded.reason);
      else if (decoded.value.kind === 'frame') take(decoded.value);
      else predictor.receive(decoded.value, now());
    },
    onFrame: take,
    onClosed: (reason) => trouble.push(reason),
    onLink: (said) => words.push(said),
    onWelcome: (about) => predictor.setOwnShip(String(about['ship_id'])),
    onShipGone: (shipId) => predictor.removeShip(shipId, 'destroyed'),
    onRefused: (reason) => trouble.push(reason),
    onRun: () => undefined,
  });

  const looks = new Set<() => void>();
  const timer = setInterval(() => {
    predictor.advance(NEUTRAL_CONTROLS, now());
    for (const message of predictor.takeOutgoing()) link.send(message);
    for (const look of looks) look();
  }, FRAME);

  return {
    predictor,
    view: () => predictor.view(now()),
    frames: () => frames,
    notices,
    words,
    trouble,
    fly: (look) =>
      new Promise((resolve) => {
        const check = () => {
          if (!look(predictor.view(now()), now())) return;
          looks.delete(check);
          resolve();
        };
        looks.add(check);
      }),
    dispose() {
      clearInterval(timer);
      link.dispose();
    },
  };
}
