/** The world loop that plays the server, with the same dynamics: in a worker, in tests, in node. */

export { type Authority, createAuthority } from './authority';
/** When its ticks are due. */
export { type Loop, MAX_CATCH_UP, runDueTicks, runNextTick, setFrozen, skipBacklog, startLoop } from './loop';
export { type AuthorityOptions } from './options';
export { type Counters, MAX_QUEUED } from './pilots';
/** Ships as they are put into a world. */
export { type SpawnOrder } from './roster';
/** A row as the wire's record. */
export { type ShipIdentity, type ShipPlace } from './shipState';
export { type Tempo } from './tempo';
/** Rotations of plain tuples, exact. */
export { add, compose, cross, inverse, rotate } from './rotation';
