/** Playing, reading and writing recordings, in a part of its own: it is fetched when it is first asked for. */
export { fileName, readFile, refusalWords, writeSlowly } from './recordingFile';
export { createReplay } from './replay';
