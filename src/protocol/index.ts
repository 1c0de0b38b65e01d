/** Which version of the messages is spoken, and how another stands to it: for those who write, read and use a hello. */
export { FIRST_VERSION, matchVersion, PROTOCOL_VERSION } from './version';
