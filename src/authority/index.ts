/** The world loop that plays the server with the same dynamics: in a worker, in tests, in node. */

export { type Authority, createAuthority } from './authority';
/** Schedules its ticks. */
export { type Loop, MAX_CATCH_UP, runDueTicks, runNextTick, setFrozen, skipBacklog, startLoop } from './loop';
export { type AuthorityOptions } from './options';
export { type Counters } from './counters';
export { MAX_QUEUED } from './inputQueue';
/** Ships to spawn. */
export { type SpawnOrder } from './shipTable';
/** A ship's row as the wire's record. */
export { type ShipIdentity, type ShipPlace } from './shipState';
export { type Tempo } from './tempo';
/** Exact rotations of plain tuples. */
export { add, compose, cross, inverse, rotate } from './rotation';
