import { type Controls, createPredictor, decodeFrameJson, type WorldView } from '../../src';
import { decodeServerMessage, encodeClientMessage } from '../../src/protobuf';

// #region protobuf
const predictor = createPredictor({ ownShipId: 'my-ship' });
const seconds = (): number => performance.now() / 1000;

/** On the socket's `message` event, where `_clientPos` and `_blendOffset` were set. */
export function onBytes(bytes: Uint8Array): void {
  const message = decodeServerMessage(bytes);
  if (message.ok) predictor.receive(message.value, seconds());
  else predictor.refused(message.reason);
}

/** On each display frame, where the position was extrapolated under gravity. */
export function onFrame(controls: Controls, send: (bytes: Uint8Array) => void): WorldView {
  const now = seconds();
  predictor.advance(controls, now);
  for (const message of predictor.takeOutgoing()) send(encodeClientMessage(message));
  return predictor.view(now);
}
// #endregion

// #region json
/** The game's own JSON: the object with `tick` and `ships`, and any other members of a frame. */
export function onJson(state: unknown): void {
  const frame = decodeFrameJson(state);
  if (!frame.ok) {
    predictor.refused(frame.reason);
    return;
  }
  for (const refusal of frame.value.refusals) console.warn(`left out: ${refusal}`);
  predictor.receive(frame.value, seconds());
}
// #endregion

// #region drawing
/** Places the mesh and returns the status text. */
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
