import { findScenario, FREE_FLIGHT, LESSONS, MISSIONS, SCENARIOS } from '../../scenarios';
import { isRealServer, MAX_PILOT_NAME } from '../server/tabAddress';
import type { Choices } from './choices';
import { append, appendButton, appendDetails, createSelect, createText } from './elements';
import { createForm } from './form';
import type { ButtonRow, PanelAction, WorkshopParts } from './panelActions';

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

/** Buttons that are disabled where another page or a real server has the world. */
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
  'tryTopple',
];

const RUN: ButtonRow = [
  ['restart', 'Restart'],
  ['pause', 'Pause'],
  ['help', 'Keys'],
  ['sound', 'Sound'],
];

/** The playground's form: native controls, each with its label. Missions on top, the workshop folded below. */
export function createPanel(
  host: HTMLElement,
  { workshopOpen }: { readonly workshopOpen: boolean },
  listeners: PanelListeners,
): Panel {
  const buttons = new Map<PanelAction, HTMLButtonElement>();
  const pressed = new Map<PanelAction, boolean>();
  const addButton = (parent: Element, action: PanelAction, text: string) => {
    const button = appendButton(parent, text, () => listeners.action(action));
    if (pressed.has(action)) button.setAttribute('aria-pressed', String(pressed.get(action)));
    buttons.set(action, button);
  };
  const addRow = (parent: Element, row: ButtonRow) => {
    const element = append(parent, 'div', 'row');
    for (const [action, text] of row) addButton(element, action, text);
  };
  append(host, 'h2', '', 'Touchdown');
  const form = createForm(listeners.change);
  form.field(host, 'Mission', 'scenario', createScenarioList(host.ownerDocument));
  const about = append(host, 'p', 'quiet');
  form.also((choices) => (about.textContent = aboutOf(choices)));
  addRow(host, RUN);
  const starts = append(host, 'div', 'row');
  const worlds = appendWorlds(starts, listeners.change);
  addButton(starts, 'invite', 'Fly together');
  form.field(append(host, 'div'), 'Your name', 'pilot', createNameField(host.ownerDocument));

  const workshop = appendDetails(host, 'Workshop', workshopOpen);
  workshop.addEventListener('toggle', () => {
    if (workshop.open) loadSettings();
    listeners.workshop(workshop.open);
  });
  const loadSettings = createSettingsLoader(workshop, { form, addButton, addRow }, listeners.failed);
  if (workshopOpen) loadSettings();
  let run = '';
  const paintRun = () => {
    const line = workshop.querySelector('.run');
    if (line !== null) line.textContent = run;
  };
  form.also(paintRun);
  form.also(({ server, mode }) => {
    for (const button of [...worlds, ...BUILT_IN_ONLY.map((action) => buttons.get(action))])
      button?.toggleAttribute('disabled', server !== '');
    buttons.get('tryLastState')?.setAttribute('aria-pressed', String(mode === 'last'));
  });

  return {
    show: form.show,
    press(action, isPressed) {
      pressed.set(action, isPressed);
      buttons.get(action)?.setAttribute('aria-pressed', String(isPressed));
    },
    label(action, text) {
      const known = buttons.get(action);
      if (known !== undefined && known.textContent !== text) known.textContent = text;
    },
    showRun(text) {
      run = text;
      paintRun();
    },
  };
}

/** The world of a real server is no scenario of the page. */
function aboutOf({ scenario, server }: Choices): string {
  return isRealServer(server) ? '' : (findScenario(scenario)?.about ?? '');
}

function appendWorlds(row: Element, change: PanelListeners['change']): readonly HTMLButtonElement[] {
  return [
    appendButton(row, 'Flight school', () => change('scenario', LESSONS[0]!.scenario.name)),
    appendButton(row, 'Free flight', () => change('scenario', FREE_FLIGHT.name)),
  ];
}

/** For those who fly together or race a link. */
function createNameField(document: Document): HTMLInputElement {
  const field = createText(document, 'as others see it');
  field.maxLength = MAX_PILOT_NAME;
  return field;
}

/** The workshop's code is loaded when it opens for the first time. */
function createSettingsLoader(host: Element, parts: WorkshopParts, failed: () => void): () => void {
  let isLoading = false;
  return () => {
    if (isLoading) return;
    isLoading = true;
    import('./settings').then(
      ({ appendWorkshop }) => {
        appendWorkshop(host, parts);
        parts.form.showAgain();
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
    ['Without a goal', [FREE_FLIGHT]],
    ['Demonstrations', SCENARIOS],
  ] as const;
  for (const [title, scenarios] of groups) {
    const group = append(select, 'optgroup');
    group.label = title;
    for (const { name, title: text } of scenarios) append(group, 'option', '', text).value = name;
  }
  return select;
}
