import { findScenario, LESSONS, MISSIONS, SCENARIOS } from '../../scenarios';
import type { Choices } from './choices';
import { append, appendButton, appendDetails, appendLicences, createSelect } from './elements';
import { createForm, type Form } from './form';

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

export interface PanelListeners {
  /** A field was changed. Returns why it is invalid, or null. */
  readonly change: (name: keyof Choices, text: string) => string | null;
  readonly action: (action: PanelAction) => void;
  /** The workshop was opened or closed. */
  readonly workshop: (open: boolean) => void;
  /** A part of the panel did not load. */
  readonly failed: () => void;
}

export interface Panel {
  /** Shows the present choices. */
  readonly show: (choices: Choices) => void;
  readonly press: (action: PanelAction, pressed: boolean) => void;
  readonly label: (action: PanelAction, text: string) => void;
  /** Tick and hash of the run. */
  readonly showRun: (text: string) => void;
}

/** Disables what does not apply to a real server. */
const BUILT_IN_ONLY: readonly PanelAction[] = [
  'restart',
  'pause',
  'stepSubstep',
  'kick',
  'spike',
  'freeze',
  'drop',
  'snapshot',
  'restore',
  'drag',
  'copyFlight',
  'invite',
];

type ButtonRow = readonly (readonly [action: PanelAction, text: string])[];

const RUN: ButtonRow = [
  ['restart', 'Restart'],
  ['pause', 'Pause'],
  ['help', 'Keys'],
  ['sound', 'Sound'],
];
const TRIES: ButtonRow = [
  ['tryHop', 'Hop: full throttle for a second, then land again'],
  ['tryTopple', 'Tip over, then right the ship with the key shown'],
  ['tryLastState', 'See the same without prediction'],
];
const TROUBLES: ButtonRow = [
  ['kick', 'Kick the ship'],
  ['spike', 'Lag spike'],
  ['freeze', 'Freeze the server'],
  ['drop', 'Drop the connection'],
  ['away', 'Hide for a minute'],
];
const EXPERIMENTS: ButtonRow = [
  ['stepSubstep', 'Step'],
  ['snapshot', 'Snapshot'],
  ['restore', 'Restore'],
  ['drag', 'Move the ship'],
];
const SHARE: ButtonRow = [
  ['copyLink', 'Copy link'],
  ['copyFlight', 'Copy flight link'],
  ['resetCamera', 'Reset view'],
  ['nextCamera', 'Next camera'],
];

/** The playground's form: native controls, each with its label. Missions on top, the workshop folded below. */
export function createPanel(
  host: HTMLElement,
  { workshopOpen }: { readonly workshopOpen: boolean },
  listeners: PanelListeners,
): Panel {
  const buttons = new Map<PanelAction, HTMLButtonElement>();
  const addButton = (parent: Element, action: PanelAction, text: string) =>
    buttons.set(
      action,
      appendButton(parent, text, () => listeners.action(action)),
    );
  const addRow = (parent: Element, row: ButtonRow) => {
    const element = append(parent, 'div', 'row');
    for (const [action, text] of row) addButton(element, action, text);
  };
  append(host, 'h2', '', 'Touchdown');
  const form = createForm(listeners.change);
  form.field(host, 'Mission', 'scenario', createScenarioList(host.ownerDocument));
  const about = append(host, 'p', 'quiet');
  form.also(({ scenario }) => (about.textContent = findScenario(scenario)?.about ?? ''));
  addRow(host, RUN);
  const starts = append(host, 'div', 'row');
  appendButton(starts, 'Flight school', () => listeners.change('scenario', LESSONS[0]!.scenario.name));
  appendButton(starts, 'Free flight', () => listeners.change('scenario', 'launch'));
  addButton(starts, 'invite', 'Fly together');

  const workshop = appendDetails(host, 'Workshop', workshopOpen);
  workshop.addEventListener('toggle', () => {
    if (workshop.open) loadSettings();
    listeners.workshop(workshop.open);
  });
  append(workshop, 'h3', '', 'Three things to try');
  const tries = append(workshop, 'ul', 'tries');
  for (const [action, text] of TRIES) addButton(append(tries, 'li'), action, text);
  const settings = append(workshop, 'div');
  const loadSettings = createSettingsLoader(settings, form, listeners.failed);
  if (workshopOpen) loadSettings();
  append(workshop, 'h3', '', 'Experiment');
  addRow(workshop, EXPERIMENTS);
  append(workshop, 'h3', '', 'Disturb');
  addRow(workshop, TROUBLES);
  append(workshop, 'h3', '', 'Share and view');
  addRow(workshop, SHARE);
  const run = append(workshop, 'p', 'quiet');
  appendLicences(append(workshop, 'p', 'quiet'));
  form.also(({ server, mode }) => {
    for (const action of BUILT_IN_ONLY) buttons.get(action)!.disabled = server !== '';
    buttons.get('tryLastState')!.setAttribute('aria-pressed', String(mode === 'last'));
  });

  return {
    show: form.show,
    press: (action, pressed) => buttons.get(action)?.setAttribute('aria-pressed', String(pressed)),
    label(action, text) {
      const known = buttons.get(action);
      if (known !== undefined && known.textContent !== text) known.textContent = text;
    },
    showRun(text) {
      if (run.textContent !== text) run.textContent = text;
    },
  };
}

/** The settings' code is loaded when the workshop opens for the first time. */
function createSettingsLoader(host: Element, form: Form, failed: () => void): () => void {
  let isLoading = false;
  return () => {
    if (isLoading) return;
    isLoading = true;
    import('./settings').then(
      ({ appendSettings }) => {
        appendSettings(host, form);
        form.showAgain();
      },
      () => {
        isLoading = false;
        failed();
      },
    );
  };
}

function createScenarioList(document: Document): HTMLSelectElement {
  const select = createSelect(document, []);
  const groups = [
    ['Missions', MISSIONS.map(({ scenario }) => scenario)],
    ['Flight school', LESSONS.map(({ scenario }) => scenario)],
    ['Demonstrations', SCENARIOS],
  ] as const;
  for (const [title, scenarios] of groups) {
    const group = append(select, 'optgroup');
    group.label = title;
    for (const { name, title: text } of scenarios) append(group, 'option', '', text).value = name;
  }
  return select;
}
