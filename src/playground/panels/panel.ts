import { findScenario, LESSONS, MISSIONS, SCENARIOS } from '../../scenarios';
import type { Choices } from './choices';
import { append, appendButton, appendDetails, createSelect } from './elements';
import { createForm } from './form';
import { appendSettings } from './settings';

/** Buttons of the panel. */
export type PanelAct =
  | 'restart'
  | 'pause'
  | 'stepSubstep'
  | 'kick'
  | 'freeze'
  | 'drop'
  | 'away'
  | 'copyLink'
  | 'invite'
  | 'help'
  | 'sound'
  | 'resetCamera'
  | 'nextCamera'
  | 'tryHop'
  | 'tryTopple'
  | 'tryLastState';

export interface PanelListeners {
  /** A field was changed; gives why not, or null. */
  readonly change: (name: keyof Choices, text: string) => string | null;
  readonly act: (act: PanelAct) => void;
  /** The workshop was opened or closed. */
  readonly workshop: (open: boolean) => void;
}

export interface Panel {
  /** Shows the choices as they are. */
  readonly show: (choices: Choices) => void;
  readonly press: (act: PanelAct, pressed: boolean) => void;
  readonly label: (act: PanelAct, text: string) => void;
  /** Tick and hash of the run. */
  readonly showRun: (text: string) => void;
}

/** What a real server does not take. */
const BUILT_IN_ONLY: readonly PanelAct[] = [
  'restart',
  'pause',
  'stepSubstep',
  'kick',
  'freeze',
  'drop',
  'invite',
];

/** The playground's form: native controls, each with its label. Missions on top, the workshop folded below. */
export function createPanel(
  host: HTMLElement,
  { workshopOpen }: { readonly workshopOpen: boolean },
  listeners: PanelListeners,
): Panel {
  const buttons = new Map<PanelAct, HTMLButtonElement>();
  const button = (parent: Element, act: PanelAct, text: string) =>
    buttons.set(
      act,
      appendButton(parent, text, () => listeners.act(act)),
    );
  append(host, 'h2', '', 'Touchdown');
  const form = createForm(listeners.change);
  form.field(host, 'Mission', 'scenario', createScenarioList(host.ownerDocument));
  const about = append(host, 'p', 'quiet');
  form.also(({ scenario }) => (about.textContent = findScenario(scenario)?.about ?? ''));
  const runs = append(host, 'div', 'row');
  button(runs, 'restart', 'Restart');
  button(runs, 'pause', 'Pause');
  button(runs, 'help', 'Keys');
  button(runs, 'sound', 'Sound');
  const schools = append(host, 'div', 'row');
  appendButton(schools, 'Flight school', () => listeners.change('scenario', LESSONS[0]!.scenario.name));
  appendButton(schools, 'Free flight', () => listeners.change('scenario', 'launch'));
  button(schools, 'invite', 'Fly together');

  const workshop = appendDetails(host, 'Workshop', workshopOpen);
  workshop.addEventListener('toggle', () => listeners.workshop(workshop.open));
  append(workshop, 'h3', '', 'Three things to try');
  const tries = append(workshop, 'ul', 'tries');
  button(append(tries, 'li'), 'tryHop', 'Hop: full throttle for a second, then land again');
  button(append(tries, 'li'), 'tryTopple', 'Tip over, then right the ship with the key shown');
  button(append(tries, 'li'), 'tryLastState', 'See the same without prediction');
  appendSettings(workshop, form);
  append(workshop, 'h3', '', 'Make trouble');
  const troubles = append(workshop, 'div', 'row');
  button(troubles, 'stepSubstep', 'Step');
  button(troubles, 'kick', 'Kick the ship');
  button(troubles, 'freeze', 'Freeze the server');
  button(troubles, 'drop', 'Drop the connection');
  button(troubles, 'away', 'Hide for a minute');
  append(workshop, 'h3', '', 'Share');
  const share = append(workshop, 'div', 'row');
  button(share, 'copyLink', 'Copy link');
  button(share, 'resetCamera', 'Reset view');
  button(share, 'nextCamera', 'Next camera');
  const run = append(workshop, 'p', 'quiet');
  form.also(({ server }) => {
    for (const act of BUILT_IN_ONLY) buttons.get(act)!.disabled = server !== '';
  });

  return {
    show: form.show,
    press: (act, pressed) => buttons.get(act)?.setAttribute('aria-pressed', String(pressed)),
    label(act, text) {
      const known = buttons.get(act);
      if (known !== undefined && known.textContent !== text) known.textContent = text;
    },
    showRun(text) {
      if (run.textContent !== text) run.textContent = text;
    },
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
