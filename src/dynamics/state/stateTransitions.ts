import { CONTACT, FLYING, LANDED, TIPPED } from './layout';

/** Which surface states may follow a state within one substep (DYNAMICS, Transitions and Launch), itself left out. */
const LEGAL_MOVES: Readonly<Record<number, readonly number[]>> = {
  [FLYING]: [CONTACT],
  [CONTACT]: [FLYING, LANDED, TIPPED],
  // A launch goes on as flying and may touch again at the end of the same substep.
  [LANDED]: [FLYING, CONTACT],
  [TIPPED]: [FLYING, CONTACT],
};

/** Whether a ship may go from one surface state to another within one substep. A crash leaves from any but landed. */
export function isTransitionAllowed(from: number, to: number): boolean {
  return from === to || (LEGAL_MOVES[from]?.includes(to) ?? false);
}
