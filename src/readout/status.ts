import type { ShipView } from '../prediction';

/** Statuses of the one slot (HUD, The design). 'none': no ship or no data yet. */
export type StatusId = 'none' | 'flight' | 'contact' | 'landed' | 'tipped' | 'crashed';

/** Each status differs in word, shape and colour, so that colour is never the only sign. */
export interface StatusLook {
  readonly id: StatusId;
  readonly word: string;
  readonly shape: '◌' | '◇' | '▲' | '■' | '✖';
  /** A name, not a value: the style sheet has the values of both colour schemes. */
  readonly colour: 'quiet' | 'neutral' | 'yellow' | 'cyan' | 'red';
}

export const STATUS_LOOKS: Readonly<Record<StatusId, StatusLook>> = Object.freeze({
  none: { id: 'none', word: 'NO DATA', shape: '◌', colour: 'quiet' },
  flight: { id: 'flight', word: 'FLIGHT', shape: '◇', colour: 'neutral' },
  contact: { id: 'contact', word: 'CONTACT', shape: '▲', colour: 'yellow' },
  landed: { id: 'landed', word: 'LANDED', shape: '■', colour: 'cyan' },
  tipped: { id: 'tipped', word: 'TIPPED', shape: '✖', colour: 'red' },
  crashed: { id: 'crashed', word: 'CRASHED', shape: '✖', colour: 'red' },
});

/** The status of a ship's shown state: the dwelled one; crashed only once the server has confirmed it. */
export function statusOf(shownState: ShipView['shownState']): StatusId {
  return shownState === '' ? 'flight' : shownState;
}
