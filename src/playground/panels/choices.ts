import { BODIES, SHIP_CLASSES, TERRAINS } from '../../dynamics';
import { readFlight } from '../game/mission/runText';
import { MAX_PILOT_NAME, TAB_ADDRESS } from '../server/tabAddress';
import { FREE_FLIGHT, LESSONS, MISSIONS, SCENARIOS } from '../../scenarios';

/** The choices of the page, all of them in the URL. */
export interface Choices {
  scenario: string;
  /** '' = the scenario's own, here and in the two that follow. */
  body: string;
  shipClass: string;
  terrain: string;
  /** Of the law: radial, or terrain: then slopes count. '' = the scenario's own. */
  surfaceNormal: '' | 'radial' | 'terrain';
  /** Hz; 0 = the scenario's own. */
  tickRate: number;
  /** 0 = the scenario's own. */
  timeScale: number;
  network: string;
  /** Numbers of network 'custom': one-way delay and jitter, ms; per cent of packets stalled, and for how long, ms. */
  delay: number;
  jitter: number;
  stalled: number;
  stall: number;
  /** Of the link to the server, where they differ; '' = as of the link from it. */
  upDelay: number | '';
  upJitter: number | '';
  upStalled: number | '';
  seed: number;
  mode: ClientMode;
  overlays: readonly OverlayName[];
  /** Wall clock of the playground, 0.1 … 4. */
  slow: number;
  /** '' = the worker. */
  server: string;
  /** The pilot's name, for others; '' = none. */
  pilot: string;
  /** Inputs that the player's ship applies by itself, as writeFlight writes them; '' = the scenario's own. */
  flight: string;
  /** Number of other ships. */
  fleet: number;
  /** 1: the worker speaks like the game's current server: no hello, no fields 31–34, whole-tick inputs. */
  legacy: number;
  /** 'auto': as fine as the machine keeps up with. 'fine': at its finest, however long a frame takes. */
  picture: PictureChoice;
}

const PICTURES = ['auto', 'fine'] as const;
export type PictureChoice = (typeof PICTURES)[number];

const CLIENT_MODES = ['predicted', 'gravity', 'last'] as const;
export type ClientMode = (typeof CLIENT_MODES)[number];
export const OVERLAY_NAMES = ['ghost', 'errorSegment', 'contactNormal', 'footprint', 'forces'] as const;
export type OverlayName = (typeof OVERLAY_NAMES)[number];

export const NETWORKS = ['lan', 'broadband', 'fourG', 'satellite', 'broken', 'custom'] as const;

export const DEFAULT_CHOICES: Choices = {
  scenario: 'first-landing',
  body: '',
  shipClass: '',
  terrain: 'hills',
  surfaceNormal: '',
  tickRate: 0,
  timeScale: 0,
  network: 'broadband',
  delay: 50,
  jitter: 8,
  stalled: 2,
  stall: 200,
  upDelay: '',
  upJitter: '',
  upStalled: '',
  seed: 1,
  mode: 'predicted',
  overlays: [],
  slow: 1,
  server: '',
  pilot: '',
  flight: '',
  fleet: 0,
  legacy: 0,
  picture: 'auto',
};

interface Field {
  readonly name: keyof Choices;
  /** In the URL. */
  readonly key: string;
  readonly expects: string;
  /** The value of a string, or undefined. */
  readonly read: (text: string) => unknown;
}

/** @param expects for a list too long for the banner */
const oneOf = (names: readonly string[], expects?: string) => ({
  expects: expects ?? `one of ${names.filter((name) => name !== '').join(', ')}`,
  read: (text: string) => (names.includes(text) ? text : undefined),
});
const between = (low: number, high: number) => ({
  expects: `a number from ${low} to ${high}`,
  read: (text: string) => {
    const value = text.trim() === '' ? NaN : Number(text);
    return value >= low && value <= high ? value : undefined;
  },
});
const whole = (low: number, high: number) => ({
  expects: `a whole number from ${low} to ${high}`,
  read: (text: string) => {
    const value = /^\d{1,10}$/.test(text) ? Number(text) : NaN;
    return value >= low && value <= high ? value : undefined;
  },
});
const orOwn = (field: { expects: string; read: (text: string) => unknown }) => ({
  expects: `${field.expects}, or 0 for the scenario's own`,
  read: (text: string) => (text === '0' ? 0 : field.read(text)),
});
const orSame = (field: { expects: string; read: (text: string) => unknown }) => ({
  expects: `${field.expects}, or empty: as the link from the server`,
  read: (text: string) => (text.trim() === '' ? '' : field.read(text)),
});
const names = (given: readonly { readonly name: string }[]) => ['', ...given.map(({ name }) => name)];

/** Missions, lessons and scenarios, in the order in which the keys step through them. */
export const SCENARIO_NAMES: readonly string[] = [
  ...MISSIONS.map(({ scenario }) => scenario.name),
  ...LESSONS.map(({ scenario }) => scenario.name),
  FREE_FLIGHT.name,
  ...SCENARIOS.map(({ name }) => name),
];

/** The list of everything that a link may contain. */
const FIELDS: readonly Field[] = [
  {
    name: 'scenario',
    key: 'scenario',
    ...oneOf(SCENARIO_NAMES, 'the name of a mission, a lesson or a scenario'),
  },
  { name: 'body', key: 'body', ...oneOf(names(BODIES)) },
  { name: 'shipClass', key: 'ship', ...oneOf(names(SHIP_CLASSES)) },
  { name: 'terrain', key: 'terrain', ...oneOf(['', ...Object.keys(TERRAINS)]) },
  { name: 'surfaceNormal', key: 'normal', ...oneOf(['', 'radial', 'terrain']) },
  { name: 'tickRate', key: 'rate', ...orOwn(between(0.1, 100)) },
  { name: 'timeScale', key: 'scale', ...orOwn(between(0.1, 100)) },
  { name: 'network', key: 'net', ...oneOf(NETWORKS) },
  { name: 'delay', key: 'delay', ...between(0, 5000) },
  { name: 'jitter', key: 'jitter', ...between(0, 1000) },
  { name: 'stalled', key: 'stalled', ...between(0, 50) },
  { name: 'stall', key: 'stall', ...between(0, 10_000) },
  { name: 'upDelay', key: 'updelay', ...orSame(between(0, 5000)) },
  { name: 'upJitter', key: 'upjitter', ...orSame(between(0, 1000)) },
  { name: 'upStalled', key: 'upstalled', ...orSame(between(0, 50)) },
  { name: 'seed', key: 'seed', ...whole(0, 0xffffffff) },
  { name: 'mode', key: 'mode', ...oneOf(CLIENT_MODES) },
  {
    name: 'overlays',
    key: 'show',
    expects: `a comma-separated list of ${OVERLAY_NAMES.join(', ')}`,
    read: (text) => {
      const parts = text.split(',').filter((part) => part !== '');
      return parts.every((part) => (OVERLAY_NAMES as readonly string[]).includes(part)) ? parts : undefined;
    },
  },
  { name: 'slow', key: 'slow', ...between(0.1, 4) },
  {
    name: 'server',
    key: 'server',
    expects: 'an address that begins with ws://, wss:// or tab:',
    read: (text) => (text === '' || isSocketAddress(text) || TAB_ADDRESS.test(text) ? text : undefined),
  },
  {
    name: 'pilot',
    key: 'name',
    expects: `at most ${MAX_PILOT_NAME} characters`,
    read: (text) => (text.length <= MAX_PILOT_NAME && !/\p{Surrogate}/u.test(text) ? text : undefined),
  },
  {
    name: 'flight',
    key: 'flight',
    expects: 'a flight from this page',
    read: (text) => (text === '' || readFlight(text, ANY_SUBSTEPS).ok ? text : undefined),
  },
  { name: 'fleet', key: 'fleet', ...whole(0, 999) },
  { name: 'legacy', key: 'legacy', ...whole(0, 1) },
  { name: 'picture', key: 'picture', ...oneOf(PICTURES) },
];

/** A flight is valid whatever the tick rate. */
const ANY_SUBSTEPS = 100;

function isSocketAddress(text: string): boolean {
  return /^wss?:\/\//.test(text) && text.length <= 500 && URL.canParse(text);
}

export interface ReadChoices {
  readonly choices: Choices;
  /** Which values were invalid, and what was expected. */
  readonly complaints: readonly string[];
}

/** Choices from a query; an invalid value keeps its default and is listed in `complaints`. */
export function readChoices(query: URLSearchParams): ReadChoices {
  const complaints: string[] = [];
  const choices: Choices = { ...DEFAULT_CHOICES };
  for (const { name, key, expects, read } of FIELDS) {
    const text = query.get(key);
    if (text === null) continue;
    const value = read(text);
    if (value === undefined) complaints.push(`${key}: expected ${expects}, got “${text.slice(0, 60)}”`);
    else Object.assign(choices, { [name]: value });
  }
  return { choices, complaints };
}

/** The query of these choices; defaults are left out. */
export function writeChoices(choices: Choices): string {
  const query = new URLSearchParams();
  for (const { name, key } of FIELDS) {
    const text = String(choices[name]);
    if (text !== String(DEFAULT_CHOICES[name])) query.set(key, text);
  }
  const text = query.toString();
  return text === '' ? '' : `?${text}`;
}

/** Sets one field from a form, checked as in a link. Returns the reason why it is invalid, or null. */
export function setChoice(choices: Choices, name: keyof Choices, text: string): string | null {
  const field = FIELDS.find((candidate) => candidate.name === name)!;
  const value = field.read(text);
  if (value === undefined) return `expected ${field.expects}`;
  Object.assign(choices, { [name]: value });
  return null;
}
