/** Scenarios, missions, recordings and the simulated network: shared by tests, benchmarks and the page. */

/** Landings as data, and their trajectories on the dynamics alone. */
export { SCENARIOS } from './catalogue';
export {
  type Scenario,
  type ScenarioInput,
  pilotAt,
  loadScenario,
  type LoadedScenario,
  ticksOf,
} from './scenario';
export type { ScheduledInput } from './runTick';
export { runScenario, type ScenarioRun, type ScenarioEvent } from './runScenario';
/** Local east, north, up at a place on a body. */
export {
  type Craft,
  fromBodyRelative,
  type Ground,
  type LocalState,
  type SeenFromSite,
  type Site,
  siteToIcrf,
  toBodyRelative,
} from './site';
/** Seeded random numbers, the same in every engine. */
export { normalNoise, createRandom, type Random } from './network/random';
/** Trajectories of other implementations, and the differences to this one. */
export type { Fixture, FixtureEvent, FixtureInput, FixtureState, FixtureTerrain } from './fixtures/fixture';
export { readFixture } from './fixtures/readFixture';
export {
  agrees,
  compareFixture,
  type Comparison,
  type DifferenceField,
  type Differences,
  TOLERANCES,
} from './fixtures/compareFixture';
/** The simulated delays of a WebSocket, and an authority whose clients connect through them. */
export {
  createLink,
  type Delivery,
  type Link,
  type LinkCounters,
  loadNetwork,
  NETWORK_PRESETS,
  type NetworkNumbers,
  type NetworkPreset,
} from './network/network';
export { createLoopbackLink, type LoopbackLink, type LoopbackCounters } from './network/loopbackLink';
/** Other players' ships around a scenario. */
export { fleetOrders } from './fleet';
/** Recordings of a client as JSON lines, and comparison of a recorded server with the dynamics. */
export {
  createRecordingWriter,
  readRecording,
  type Recording,
  type RecordingEntry,
  type RecordingHeader,
  type RecordingWriter,
  writeRecording,
} from './recordings/recording';
export { compareRecording, type RecordingComparison } from './recordings/compareRecording';
/** An autopilot for the last 200 metres, and for a fast drift before them. */
export { brakeDrift } from './autopilot/braking';
export { type Approach, type LandingSite } from './autopilot/descent';
export { BEGIN_LANDING, continueLanding, type LandingManeuver, type LandingPhase } from './autopilot/landing';
/** Missions as data; a run replayed from its inputs, its score, and its bytes for a link. */
export { findMission, findScenario, FREE_FLIGHT, MISSIONS } from './missions/missions';
export { LESSONS } from './missions/lessons';
export type { Mission, MissionGoal, Pad } from './missions/mission';
export { cosineOfTilt } from './tilt';
export { flyRun, type RunInput, type RunOutcome } from './missions/flyRun';
export { TRACK_RATE, TRACK_STRIDE } from './missions/track';
export { padPlaces } from './missions/pads';
export { meetsGoal, scoreRun, type Score, type ScoreLine } from './missions/score';
export { readRun, writeRun } from './missions/runBytes';
