import { BODIES, SHIP_CLASSES, TERRAINS } from '../../dynamics';
import { type Choices, NETWORKS, OVERLAY_NAMES, type OverlayName } from './choices';
import { append, appendDetails, appendLicences, createNumber, createSelect, createText } from './elements';
import type { Form } from './form';
import { createOverlayLegend } from './overlayLegend';
import type { ButtonRow, WorkshopParts } from './panelActions';

const TRIES: ButtonRow = [
  ['tryHop', 'Hop: full throttle for a second, then land again'],
  ['tryTopple', 'Tip over, then right the ship with the key shown'],
  ['tryLastState', 'See the same without prediction'],
];
const DISTURBANCES: ButtonRow = [
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

const NETWORK_WORDS: Readonly<Record<(typeof NETWORKS)[number], string>> = {
  lan: 'LAN, 2 ms',
  broadband: 'Broadband, 20 ms',
  fourG: '4G, 50 ms, 2 % stalled',
  satellite: 'Satellite, 300 ms',
  broken: 'Broken, 100 ms, 10 % stalled',
  custom: 'Custom',
};
const OVERLAY_WORDS: Readonly<Record<OverlayName, string>> = {
  ghost: 'Server ghost',
  errorSegment: 'Error segment',
  contactNormal: 'Contact normal',
  footprint: 'Footprint',
  forces: 'Forces',
};

/** `fast_frigate` → `Fast frigate`. */
function nameOf(id: string): string {
  const words = id.replaceAll('_', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The workshop beside the game: things to try, settings, experiments. */
export function appendWorkshop(host: Element, { form, addButton, addRow }: WorkshopParts): void {
  append(host, 'h3', '', 'Three things to try');
  const tries = append(host, 'ul', 'tries');
  for (const [action, text] of TRIES) addButton(append(tries, 'li'), action, text);
  appendSettings(append(host, 'div'), form);
  append(host, 'h3', '', 'Experiment');
  addRow(host, EXPERIMENTS);
  append(host, 'h3', '', 'Disturb');
  addRow(host, DISTURBANCES);
  append(host, 'h3', '', 'Share and view');
  addRow(host, SHARE);
  append(host, 'p', 'quiet run');
  appendLicences(append(host, 'p', 'quiet'));
}

/** Settings of client, network and world. */
function appendSettings(host: Element, form: Form): void {
  const document = host.ownerDocument;
  const modes = [
    ['predicted', 'Predicted'],
    ['gravity', 'Gravity only'],
    ['last', 'Last state'],
  ] as const;
  form.field(host, 'Client', 'mode', createSelect(document, modes));
  const networks = NETWORKS.map((name) => [name, NETWORK_WORDS[name]] as const);
  form.field(host, 'Network', 'network', createSelect(document, networks));
  const custom = append(host, 'div');
  form.field(custom, 'Delay, ms', 'delay', createNumber(document, 0, 5000, 1));
  form.field(custom, 'Jitter, ms', 'jitter', createNumber(document, 0, 1000, 1));
  form.field(custom, 'Stalled, %', 'stalled', createNumber(document, 0, 50, 0.1));
  form.field(custom, 'Stall, ms', 'stall', createNumber(document, 0, 10_000, 10));
  append(custom, 'p', 'quiet', 'To the server; empty: same as from the server.');
  form.field(custom, 'Up delay, ms', 'upDelay', createNumber(document, 0, 5000, 1));
  form.field(custom, 'Up jitter, ms', 'upJitter', createNumber(document, 0, 1000, 1));
  form.field(custom, 'Up stalled, %', 'upStalled', createNumber(document, 0, 50, 0.1));
  form.also(({ network }) => (custom.hidden = network !== 'custom'));
  const speeds = createSelect(document, [0.1, 0.25, 0.5, 1, 2, 4].map(speedOption));
  // Before the field shows it: a link may have any speed.
  form.also(({ slow }) => offer(speeds, speedOption(slow)));
  form.field(host, 'Speed', 'slow', speeds);
  appendWorld(appendDetails(host, 'World', false), form);
  form.also(createChecks(host, form.change));
}

function speedOption(speed: number): readonly [value: string, text: string] {
  return [String(speed), `${speed} ×`];
}

/** Adds an option to a list that lacks it. */
function offer(list: HTMLSelectElement, [value, text]: readonly [value: string, text: string]): void {
  if ([...list.options].every((option) => option.value !== value)) list.add(new Option(text, value));
}

function appendWorld(world: Element, form: Form): void {
  const document = world.ownerDocument;
  const own = ['', 'Scenario default'] as const;
  const named = (names: readonly string[]) => names.map((name) => [name, nameOf(name)] as const);
  const list = (names: readonly string[]) => createSelect(document, [own, ...named(names)]);
  form.field(world, 'Body', 'body', list(BODIES.map(({ name }) => name)));
  form.field(world, 'Ship', 'shipClass', list(SHIP_CLASSES.map(({ name }) => name)));
  form.field(world, 'Terrain', 'terrain', list(Object.keys(TERRAINS)));
  form.field(world, 'Surface normal', 'surfaceNormal', list(['radial', 'terrain']));
  form.field(world, 'Tick rate, Hz', 'tickRate', createNumber(document, 0, 100, 0.1));
  form.field(world, 'Time scale', 'timeScale', createNumber(document, 0, 100, 0.1));
  append(world, 'p', 'quiet', '0: scenario default.');
  form.field(world, 'Other ships', 'fleet', createNumber(document, 0, 999, 1));
  form.field(world, 'Seed', 'seed', createNumber(document, 0, 0xffffffff, 1));
  const protocols = [
    ['0', 'Current'],
    ['1', 'Legacy'],
  ] as const;
  form.field(world, 'Protocol', 'legacy', createSelect(document, protocols));
  form.field(world, 'Server', 'server', createText(document, 'built-in, or ws://…'));
}

/** Check boxes for the overlays, and a legend of those that are on. */
function createChecks(
  host: Element,
  change: (name: keyof Choices, text: string) => string | null,
): (choices: Choices) => void {
  const set = append(host, 'fieldset', 'checks');
  append(set, 'legend', '', 'Show');
  const boxes = OVERLAY_NAMES.map((name) => {
    const label = append(set, 'label');
    const box = append(label, 'input');
    box.type = 'checkbox';
    append(label, 'span', '', OVERLAY_WORDS[name]);
    box.addEventListener('change', () => {
      const chosen = OVERLAY_NAMES.filter((_, i) => boxes[i]!.checked);
      change('overlays', chosen.join(','));
    });
    return box;
  });
  const showLegend = createOverlayLegend(host);
  return ({ overlays }) => {
    OVERLAY_NAMES.forEach((name, i) => (boxes[i]!.checked = overlays.includes(name)));
    showLegend(overlays);
  };
}
