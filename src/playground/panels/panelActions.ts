import type { Form } from './form';

/** Buttons of the panel. */
export type PanelAction =
  | 'restart'
  | 'pause'
  | 'stepSubstep'
  | 'kick'
  | 'spike'
  | 'freeze'
  | 'drop'
  | 'away'
  | 'snapshot'
  | 'restore'
  | 'drag'
  | 'copyLink'
  | 'copyFlight'
  | 'invite'
  | 'help'
  | 'sound'
  | 'resetCamera'
  | 'nextCamera'
  | 'tryHop'
  | 'tryTopple'
  | 'tryLastState';

export type ButtonRow = readonly (readonly [action: PanelAction, text: string])[];

/** Where the workshop's parts go: its fields, and buttons of the panel. */
export interface WorkshopParts {
  readonly form: Form;
  readonly addButton: (parent: Element, action: PanelAction, text: string) => void;
  readonly addRow: (parent: Element, row: ButtonRow) => void;
}
