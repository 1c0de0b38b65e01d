/**
 * The door for the game's client: everything it needs, and what each part is for. See prediction/README.md for the one page that
 * replaces the gravity-only extrapolation.
 */

/** The law of motion and contact: the same bits as the server's. */
export {
  BODIES,
  type Body,
  type BodyMotion,
  type Result,
  type Controls,
  DEFAULT_SETTINGS,
  loadControls,
  type LoadedSettings,
  type LoadedShipClass,
  NEUTRAL_CONTROLS,
  type Quat,
  type Settings,
  SHIP_CLASSES,
  type ShipClass,
  type ShipEventName,
  type SurfaceState,
  type TerrainHeight,
  TERRAINS,
  type Vec3,
} from './dynamics';

/** Bytes and the game's JSON <-> checked records: nothing unchecked goes further in. */
export {
  type BodyState,
  type ClientMessage,
  decodeControlsJson,
  type DecodedFrame,
  type DecodedHello,
  decodeFrameJson,
  decodeHelloJson,
  decodeServerMessage,
  decodeShipStateJson,
  decodeShipStatesJson,
  encodeClientMessage,
  encodeControlsJson,
  encodeFrameJson,
  encodeHelloJson,
  encodeShipStateJson,
  type FrameJsonOptions,
  type Hello,
  type InputRecord,
  type PartialFrame,
  type ServerFrame,
  type ServerMessage,
  type ShipState,
  type WorldEvent,
} from './wire';

/** Server truth + own controls -> a pose for now, the states shown and the events. */
export {
  createPredictor,
  createGroundedPose,
  type Diagnosis,
  type EventNotice,
  type GroundPose,
  type DrawnGround,
  type Hull,
  hullOf,
  type Predictor,
  type PredictorEntry,
  type PredictorOptions,
  type Provenance,
  recordPredictor,
  replayEntries,
  type ShipView,
  snapToGround,
  type GroundedPose,
  type WorldView,
} from './prediction';

/** The numbers a pilot reads, from a view. */
export * from './readout';

/** The landing and fleet displays: painting only, of those numbers. */
export * from './hud';
