import { BODIES, SHIP_CLASSES, TERRAINS } from '../../dynamics';
import { SCENARIOS } from '../../scenarios';
import { type Choices, NETWORKS, OVERLAY_NAMES, type OverlayName } from './choices';
import { append, appendButton, appendDetails, appendField, createNumber, createSelect } from './elements';

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
  | 'help'
  | 'resetCamera'
  | 'tryHop'
  | 'tryTopple'
  | 'tryLastState';

export interface PanelListeners {
  /** A field was changed; gives why not, or null. */
  readonly change: (name: keyof Choices, text: string) => string | null;
  readonly act: (act: PanelAct) => void;
}

export interface Panel {
  /** Shows the choices as they are. */
  readonly show: (choices: Choices) => void;
  readonly press: (act: PanelAct, pressed: boolean) => void;
  readonly label: (act: PanelAct, text: string) => void;
  /** Tick and bits of the run. */
  readonly showRun: (text: string) => void;
}

const NETWORK_WORDS: Readonly<Record<(typeof NETWORKS)[number], string>> = {
  lan: 'LAN, 2 ms',
  broadband: 'Broadband, 20 ± 3 ms',
  fourG: '4G, 50 ± 8 ms, 2 % stalled',
  satellite: 'Satellite, 300 ± 15 ms',
  broken: 'Broken, 100 ± 30 ms, 10 % stalled',
  custom: 'My own numbers',
};
const OVERLAY_WORDS: Readonly<Record<OverlayName, string>> = {
  ghost: 'Server ghost',
  errorSegment: 'Error segment',
  contactNormal: 'Contact normal',
  footprint: 'Footprint',
  forces: 'Forces',
};

/** The playground's form: native controls, each with its label. */
export function createPanel(host: Element, listeners: PanelListeners): Panel {
  const document = host.ownerDocument;
  const buttons = new Map<PanelAct, HTMLButtonElement>();
  const shows: ((choices: Choices) => void)[] = [];

  const button = (parent: Element, act: PanelAct, text: string) =>
    buttons.set(
      act,
      appendButton(parent, text, () => listeners.act(act)),
    );
  const field = (
    parent: Element,
    title: string,
    name: keyof Choices,
    control: HTMLInputElement | HTMLSelectElement,
  ) => {
    const made = appendField(parent, title, control);
    control.addEventListener('change', () => made.complain(listeners.change(name, control.value) ?? ''));
    shows.push((choices) => {
      const text = String(choices[name]);
      if (control.value !== text) control.value = text;
      made.complain('');
    });
  };

  append(host, 'h2', '', 'Touchdown');
  const about = append(host, 'p', 'quiet');
  shows.push((choices) => {
    about.textContent = SCENARIOS.find(({ name }) => name === choices.scenario)?.about ?? '';
  });
  append(host, 'h3', '', 'Three things to try');
  const tries = append(host, 'ul', 'tries');
  button(append(tries, 'li'), 'tryHop', 'Hop: full throttle for a second, then land again');
  button(append(tries, 'li'), 'tryTopple', 'Fall over, and right the ship with the key the display names');
  button(append(tries, 'li'), 'tryLastState', 'See the same without prediction');

  append(host, 'h3', '', 'Run');
  const runs = append(host, 'div', 'row');
  button(runs, 'restart', 'Restart');
  button(runs, 'pause', 'Pause');
  button(runs, 'stepSubstep', 'Step');
  button(runs, 'help', 'Keys');
  const scenarios = SCENARIOS.map(({ name, title }) => [name, title] as const);
  field(host, 'Scenario', 'scenario', createSelect(document, scenarios));
  field(
    host,
    'Client',
    'mode',
    createSelect(document, [
      ['predicted', 'Predicted'],
      ['gravity', 'Gravity only'],
      ['last', 'Last state'],
    ]),
  );
  field(
    host,
    'Network',
    'network',
    createSelect(
      document,
      NETWORKS.map((name) => [name, NETWORK_WORDS[name]]),
    ),
  );
  const custom = append(host, 'div');
  field(custom, 'Delay, ms', 'delay', createNumber(document, 0, 5000, 1));
  field(custom, 'Jitter, ms', 'jitter', createNumber(document, 0, 1000, 1));
  field(custom, 'Stalled, %', 'stalled', createNumber(document, 0, 50, 0.1));
  field(custom, 'Stall, ms', 'stall', createNumber(document, 0, 10_000, 10));
  shows.push((choices) => (custom.hidden = choices.network !== 'custom'));
  field(
    host,
    'Slow motion',
    'slow',
    createSelect(
      document,
      [0.1, 0.25, 0.5, 1, 2, 4].map((speed) => [String(speed), `${speed} ×`]),
    ),
  );

  const world = appendDetails(host, 'World', false);
  const own = ['', 'As the scenario says'] as const;
  const named = (list: readonly { readonly name: string }[]) => list.map(({ name }) => [name, name] as const);
  field(world, 'Body', 'body', createSelect(document, [own, ...named(BODIES)]));
  field(world, 'Ship', 'shipClass', createSelect(document, [own, ...named(SHIP_CLASSES)]));
  const terrains = Object.keys(TERRAINS).map((name) => [name, name] as const);
  field(world, 'Terrain', 'terrain', createSelect(document, [own, ...terrains]));
  field(world, 'Tick rate, Hz', 'tickRate', createNumber(document, 0, 100, 0.1));
  field(world, 'Time scale', 'timeScale', createNumber(document, 0, 100, 0.1));
  append(world, 'p', 'quiet', '0: as the scenario says.');
  field(world, 'Other ships', 'fleet', createNumber(document, 0, 999, 1));
  field(world, 'Seed', 'seed', createNumber(document, 0, 0xffffffff, 1));
  field(
    world,
    'Server speaks',
    'legacy',
    createSelect(document, [
      ['0', 'This protocol'],
      ['1', 'As today: whole ticks, ICRF alone'],
    ]),
  );
  const server = document.createElement('input');
  server.type = 'text';
  server.placeholder = 'ws://… (empty: in this page)';
  field(world, 'Server', 'server', server);

  shows.push(createChecks(host, listeners));
  append(host, 'h3', '', 'Make trouble');
  const troubles = append(host, 'div', 'row');
  button(troubles, 'kick', 'Kick the ship');
  button(troubles, 'freeze', 'Freeze the server');
  button(troubles, 'drop', 'Drop the connection');
  button(troubles, 'away', 'Hide for a minute');
  append(host, 'h3', '', 'Share');
  const share = append(host, 'div', 'row');
  button(share, 'copyLink', 'Copy link');
  button(share, 'resetCamera', 'First view');
  const run = append(host, 'p', 'quiet');

  return {
    show: (choices) => shows.forEach((show) => show(choices)),
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

/** Boxes to tick for what lies over the picture. */
function createChecks(host: Element, listeners: PanelListeners): (choices: Choices) => void {
  const set = append(host, 'fieldset', 'checks');
  append(set, 'legend', '', 'Show');
  const boxes = OVERLAY_NAMES.map((name) => {
    const label = append(set, 'label');
    const box = append(label, 'input');
    box.type = 'checkbox';
    append(label, 'span', '', OVERLAY_WORDS[name]);
    box.addEventListener('change', () => {
      const chosen = OVERLAY_NAMES.filter((_, i) => boxes[i]!.checked);
      listeners.change('overlays', chosen.join(','));
    });
    return box;
  });
  return (choices) => {
    OVERLAY_NAMES.forEach((name, i) => (boxes[i]!.checked = choices.overlays.includes(name)));
  };
}
