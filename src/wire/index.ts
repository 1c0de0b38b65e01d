/** Bytes and the game's JSON <-> checked plain records. */
export type * from './records';
