/** The version of the messages, and its compatibility with others, for all that write, read and use a hello. */
export { FIRST_VERSION, matchVersion, PROTOCOL_VERSION } from './version';
