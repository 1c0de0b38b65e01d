/** Plays, reads and writes recordings, in a separate chunk that is loaded on demand. */
export { fileName, readFile, refusalText as refusalWords, writeInSlices } from './recordingFile';
export { createReplay } from './replay';
