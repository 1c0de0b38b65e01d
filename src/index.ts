/**
 * The core of the library: contact dynamics, prediction, the game's JSON and the numbers a pilot reads. No DOM, no three.js, no
 * protobuf; further doors are `/protobuf`, `/hud`, `/scene` and `/game`. See GUIDE.md in src/example.
 *
 * Everywhere: SI units and radians, ICRF axes, quaternions in the order [x, y, z, w].
 * @packageDocumentation
 */

/** The law of motion and contact: the same bits as the server's. */
export {
  type Body,
  BODIES,
  type BodyMotion,
  type Controls,
  DEFAULT_SETTINGS,
  type LoadedSettings,
  type LoadedShipClass,
  NEUTRAL_CONTROLS,
  type Quat,
  type Result,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  type ShipEventName,
  type SurfaceState,
  type TerrainHeight,
  TERRAINS,
  type Vec3,
} from './dynamics';

/** The game's JSON <-> checked records: nothing unchecked goes further in. */
export {
  type BodyState,
  type ClientMessage,
  type DecodedFrame,
  type DecodedHello,
  decodeFrameJson,
  decodeHelloJson,
  encodeControlsJson,
  type FrameJsonOptions,
  type Hello,
  type InputRecord,
  type PartialFrame,
  type Pong,
  type ServerFrame,
  type ServerMessage,
  type ShipState,
  type WorldEvent,
} from './wire';

/** Server truth + own controls -> a pose for now, the states shown and the events. */
export {
  createPredictor,
  type Defaults,
  type Diagnosis,
  type EventNotice,
  type Hull,
  hullOf,
  type Predictor,
  type PredictorEntry,
  type PredictorOptions,
  type Provenance,
  recordPredictor,
  type Removal,
  replayEntries,
  type ScheduledInput,
  type ShipView,
  type TouchdownView,
  type Warn,
  type WorldView,
} from './prediction';

/** The numbers a pilot reads, from a view. */
export {
  createFleetReadout,
  createLandingReadout,
  type Descent,
  type Drift,
  type FleetReadout,
  type FleetRow,
  type Gate,
  type Gates,
  type LandingReadout,
  type Righting,
  STATUS_LOOKS,
  type StatusId,
  type StatusLook,
  type Tilt,
  type TipMargin,
  type Touchdown,
  updateFleetReadout,
  updateLandingReadout,
} from './readout';
