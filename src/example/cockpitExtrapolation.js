// Replaces the gravity-only extrapolation of `_clientPos` and the blending of `_blendOffset`.
import { createPredictor } from 'galaxy-touchdown';
import { createGameConnection } from 'galaxy-touchdown/game';
import { terrainHeight } from './terrain.js';

/** The one clock of the client: monotonic wall seconds. */
export const seconds = () => performance.now() / 1000;

/** Connects predictor and server; `onStatus` receives the link's status as text. */
export function createCockpitExtrapolation({ address, token, shipId, onStatus }) {
  const predictor = createPredictor({
    ownShipId: shipId,
    terrains: { client: terrainHeight },
    defaults: { terrain: 'client' },
    onWarning: (code, message) => console.warn(`${code}: ${message}`),
  });
  const connection = createGameConnection(
    {
      address,
      token,
      clock: { now: seconds, after },
      jitter: Math.random,
      openSocket: (url) => new WebSocket(url),
    },
    {
      onWelcome: ({ ship_id: id }) => predictor.setOwnShip(typeof id === 'string' ? id : shipId),
      onFrame: (frame, at) => predictor.receive(frame, at),
      onShipGone: (id, own) => predictor.removeShip(id, own === null ? 'gone' : 'destroyed'),
      onRefused: (reason) => predictor.refused(reason),
      onStatus: ({ text }) => onStatus(text),
    },
  );

  /** Once per display frame: takes own controls, sends changes to the server, returns the world at the present. */
  function frame(controls) {
    const now = seconds();
    predictor.advance(controls, now);
    const changed = predictor.takeControls();
    if (changed !== null) connection.sendControls(changed);
    return predictor.view(now);
  }

  return { frame, dispose: () => connection.dispose() };
}

function after(wait, act) {
  const timer = setTimeout(act, wait * 1000);
  return () => clearTimeout(timer);
}
