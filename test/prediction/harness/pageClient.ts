import {
  type ClientMessage,
  type Controls,
  createPredictor,
  decodeFrameJson,
  NEUTRAL_CONTROLS,
  type Predictor,
} from '../../../src/index';

/** The client of a page in a real browser: a socket, a frame loop, a key that may be held, and a note of what was drawn. */

/** One display frame. */
export interface Drawn {
  /** Epoch s. */
  readonly at: number;
  readonly tick: number;
  readonly sinceTick: number;
  readonly shipId: string;
  readonly position: readonly number[];
  readonly shown: string;
  readonly provenance: string;
}

export interface PageClient {
  readonly drawn: Drawn[];
  readonly troubles: string[];
  readonly predictor: Predictor;
  controls: Controls;
  /** A key of the thrusters along ship x: −1, 0 or 1. */
  readonly hold: (sideways: number) => void;
}

declare global {
  interface Window {
    client: PageClient;
    startClient: (address: string, shipId: string) => void;
  }
}

window.startClient = (address, shipId) => {
  const predictor = createPredictor({ ownShipId: shipId });
  const client: PageClient = {
    drawn: [],
    troubles: [],
    predictor,
    controls: NEUTRAL_CONTROLS,
    hold(sideways) {
      client.controls = { ...NEUTRAL_CONTROLS, translationInput: [sideways, 0, 0] };
    },
  };
  window.client = client;
  window.addEventListener('error', ({ message }) => client.troubles.push(message));
  const seconds = () => performance.now() / 1000;
  const socket = new WebSocket(address);
  socket.onmessage = ({ data }) => {
    const message = JSON.parse(data as string) as { kind?: string };
    if (message.kind === 'pong') {
      predictor.receive(message as Parameters<Predictor['receive']>[0], seconds());
      return;
    }
    const frame = decodeFrameJson(message);
    if (frame.ok) predictor.receive(frame.value, seconds());
    else client.troubles.push(frame.reason);
  };
  const send = (message: ClientMessage) => {
    if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
  };
  const draw = () => {
    const now = seconds();
    predictor.advance(client.controls, now);
    predictor.takeOutgoing().forEach(send);
    const { own, ready, tick, sinceTick } = predictor.view(now);
    if (ready && own !== null)
      client.drawn.push({
        at: (performance.timeOrigin + performance.now()) / 1000,
        tick,
        sinceTick,
        shipId: own.shipId,
        position: [...own.position],
        shown: own.shownState,
        provenance: own.provenance,
      });
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
};
