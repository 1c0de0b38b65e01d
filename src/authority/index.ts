/** The world loop that plays the server with the same dynamics: in a worker, in tests, in node. */

export { type Authority, createAuthority } from './authority';
/** Schedules its ticks. */
export {
  type Loop,
  MAX_CATCH_UP,
  runDueTicks,
  runNextTick,
  setFrozen,
  skipBacklog,
  startLoop,
} from './time/loop';
export { type AuthorityOptions } from './options';
export { type Counters } from './pilots/counters';
export { MAX_QUEUED } from './pilots/inputQueue';
/** Ships to spawn. */
export { type SpawnOrder } from './ships/shipTable';
/** A ship's row as the wire's record. */
export { type ShipIdentity, type ShipPlace } from './ships/shipState';
export { type Tempo } from './time/tempo';
/** Exact rotations of plain tuples. */
export { add, compose, cross, inverse, rotate } from './ships/rotation';
