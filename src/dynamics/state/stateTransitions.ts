import { CONTACT, FLYING, LANDED, TIPPED } from './layout';

/** Surface states that may follow each state within one substep (DYNAMICS, Transitions and Launch), besides itself. */
const STATE_TRANSITIONS: Readonly<Record<number, readonly number[]>> = {
  [FLYING]: [CONTACT],
  [CONTACT]: [FLYING, LANDED, TIPPED],
  // A launched ship flies and may touch again at the end of the same substep.
  [LANDED]: [FLYING, CONTACT],
  [TIPPED]: [FLYING, CONTACT],
};

/** Whether a ship may change from one surface state to another within one substep. A ship can crash from any state but landed. */
export function isTransitionAllowed(from: number, to: number): boolean {
  return from === to || (STATE_TRANSITIONS[from]?.includes(to) ?? false);
}
