/** Scenarios, simulated network, recordings: shared by tests, benchmarks and page. */

/** Landings as data, and what they come to on the dynamics alone. */
export { SCENARIOS } from './catalogue';
export {
  type Scenario,
  type ScenarioInput,
  pilotAt,
  stage,
  type StagedInput,
  type StagedScenario,
  ticksOf,
} from './scenario';
export { rehearse, type Rehearsed, type RehearsedEvent } from './runScenario';
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
/** Seeded numbers, the same in every engine. */
export { bell, createDice, type Dice } from './network/random';
/** Trajectories of other implementations, and how far this one is from them. */
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
/** A WebSocket's delays, simulated; and an authority with clients behind them. */
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
export { createExchange, type Exchange, type ExchangeCounters } from './network/loopbackLink';
/** Other players' ships around a scenario. */
export { fleetOrders } from './fleet';
/** What a client received, sent and was asked for, as JSON lines; and how a recorded server keeps to the law. */
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
/** A pilot for the last 200 metres. */
export { type Approach, type LandingSite } from './autopilot/descent';
export { BEGIN_LANDING, continueLanding, type LandingManeuver, type LandingPhase } from './autopilot/landing';
/** Tasks for pilots as data; a run flown again from its inputs, its score, and its bytes for a link. */
export { findMission, findScenario, MISSIONS } from './missions/missions';
export { LESSONS } from './missions/lessons';
export type { Mission, MissionGoal, Pad } from './missions/mission';
export { flyRun, type RunInput, type RunOutcome, TRACK_RATE, TRACK_STRIDE } from './missions/flyRun';
export { padPlaces } from './missions/pads';
export { meetsGoal, scoreRun, type Score, type ScoreLine } from './missions/score';
export { readRun, writeRun } from './missions/runBytes';
