/**
 * The core of the library: contact dynamics, prediction, the game's JSON and the numbers a pilot reads. No DOM, no three.js, no
 * protobuf; further doors are `/protobuf`, `/hud`, `/scene` and `/game`. See GUIDE.md in src/example.
 *
 * Everywhere: SI units and radians, ICRF axes, quaternions in the order [x, y, z, w].
 * @packageDocumentation
 */

/** The law of motion and contact: the same bits as the server's. */
export {
  type AttitudeMode,
  type Body,
  BODIES,
  type BodyMotion,
  type Controls,
  DEFAULT_SETTINGS,
  type LoadedSettings,
  type LoadedShipClass,
  type Mat3,
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
  type ClientFrame,
  type ClientMessage,
  type DecodedFrame,
  type DecodedHello,
  decodeFrameJson,
  decodeHelloJson,
  encodeControlsJson,
  type FrameJsonOptions,
  type Hello,
  type InputAcknowledgement,
  type InputRecord,
  type PartialFrame,
  type Ping,
  type Pong,
  type ServerFrame,
  type ServerMessage,
  type ShipState,
  type WorldEvent,
} from './wire';

/** Server truth + own controls -> a pose for now, the states shown and the events. */
export {
  type Channel,
  connectPredictor,
  createPredictor,
  type Defaults,
  type Diagnosis,
  type EventNotice,
  type FromWorker,
  type Hull,
  hullOf,
  type Predictor,
  type PredictorEntry,
  type PredictorOptions,
  type PredictorSnapshot,
  type Provenance,
  recordPredictor,
  type RemotePredictor,
  type Removal,
  replayEntries,
  type ScheduledInput,
  servePredictor,
  type ShipView,
  type TouchdownView,
  type ToWorker,
  type Warn,
  type WorldView,
} from './prediction';

/** The numbers a pilot reads, from a view. */
export {
  createFleetReadout,
  createFlightReadout,
  createLandingAids,
  createLandingReadout,
  createTargetReadout,
  type Descent,
  type Drift,
  type FleetReadout,
  type FleetRow,
  type FlightReadout,
  type Gate,
  type Gates,
  type HintAction,
  type LandingAids,
  type LandingReadout,
  type Righting,
  type RotationAction,
  STATUS_LOOKS,
  type StatusId,
  type StatusLook,
  type Target,
  type TargetReadout,
  type Tilt,
  type TipMargin,
  type Touchdown,
  type TranslationAction,
  updateFleetReadout,
  updateFlightReadout,
  updateLandingAids,
  updateLandingReadout,
  updateTargetReadout,
} from './readout';
