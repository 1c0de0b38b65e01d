import {
  type Controls,
  createPredictor,
  decodeShipStatesJson,
  type ServerMessage,
  type WorldView,
} from '../../src';
import { decodeServerMessage, encodeClientMessage } from '../../src/protobuf';

// #region protobuf
const predictor = createPredictor({ ownShipId: 'my-ship' });
const seconds = (): number => performance.now() / 1000;

/** The socket's `message`: where `_clientPos` and `_blendOffset` were set. */
export function onBytes(bytes: Uint8Array): void {
  const message = decodeServerMessage(bytes);
  if (message.ok) predictor.receive(message.value, seconds());
  else predictor.refused(message.reason);
}

/** Each display frame: where the position was extrapolated under gravity. */
export function onFrame(controls: Controls, send: (bytes: Uint8Array) => void): WorldView {
  const now = seconds();
  predictor.advance(controls, now);
  for (const message of predictor.takeOutgoing()) send(encodeClientMessage(message));
  return predictor.view(now);
}
// #endregion

// #region json
/** The game's own JSON: `ships` as its socket has them, and the tick they are of. */
export function onJson(tick: number, tickRate: number, ships: unknown): void {
  const states = decodeShipStatesJson(ships);
  if (!states.ok) {
    predictor.refused(states.reason);
    return;
  }
  const frame: ServerMessage = {
    kind: 'frame',
    ...{ tick, tickRate, timeScale: 1, paused: false },
    ships: states.value,
    // Where the bodies are, if the socket says so; without it they move from the defaults by the law.
    bodies: [],
    events: [],
    lastInput: null,
  };
  predictor.receive(frame, seconds());
}
// #endregion

// #region drawing
/** What to draw, and what to show. */
export function place(view: WorldView, mesh: { position: Float64Array; attitude: Float64Array }): string {
  const ship = view.own;
  if (ship === null) return '';
  mesh.position = ship.meshPosition;
  mesh.attitude = ship.meshAttitude;
  const withdrawn = ship.withdrawn === '' ? '' : `, ${ship.withdrawn} withdrawn`;
  return `${ship.shownState} (${ship.provenance}${withdrawn}), ${ship.feetHeight.toFixed(1)} m`;
}

predictor.onEvent(({ kind, type, shipId }) => console.log(`${kind}: ${type} of ${shipId}`));
// #endregion
