/** Server truth and own controls -> a pose for now. */
export type * from './view';
