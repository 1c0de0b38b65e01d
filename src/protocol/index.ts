/** The version of the messages, and its compatibility with others. */
export { FIRST_VERSION, matchVersion, PROTOCOL_VERSION } from './version';
