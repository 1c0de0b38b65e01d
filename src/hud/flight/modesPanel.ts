import type { FlightReadout } from '../../readout';
import { append } from '../elements';
import { showAttribute, showPart, showText } from '../shown';

/** The modes of attitude control and autopilot that have a key. */
export type FlightKey =
  'rateDamping' | 'modeHold' | 'modeUpright' | 'modeRetrograde' | 'killRates' | 'autopilot';

const ROWS: readonly (readonly [Exclude<FlightKey, 'killRates'>, string])[] = [
  ['rateDamping', 'Damping'],
  ['modeHold', 'Hold'],
  ['modeUpright', 'Upright'],
  ['modeRetrograde', 'Retrograde'],
  ['autopilot', 'Autopilot'],
];

const MODES: Readonly<Record<string, string>> = {
  hold: 'modeHold',
  radial: 'modeUpright',
  surface_retrograde: 'modeRetrograde',
  retrograde: 'modeRetrograde',
};

/** Each mode with its key, on or off in a word, and the command that stops the rotation. */
export function createModesPanel(
  parent: Element,
  keyLabel: (key: FlightKey) => string,
): (flight: FlightReadout, autopilot: boolean) => void {
  const list = append(parent, 'ul', 'td-modes');
  list.setAttribute('aria-label', 'Attitude modes');
  const paints = ROWS.map(([key, word]) => [key, createMode(list, word)] as const);
  const paintKillRates = createCommand(list, 'Kill rates');
  return (flight, autopilot) => {
    paintKillRates(keyLabel('killRates'));
    const mode = MODES[flight.mode] ?? '';
    for (const [key, paint] of paints) {
      const isOn =
        flight.known &&
        (key === 'autopilot'
          ? autopilot
          : key === 'rateDamping'
            ? flight.damping
            : mode === key && !autopilot);
      paint(keyLabel(key), isOn);
    }
  };
}

/** A command has no state: without a key there is nothing to show. */
function createCommand(list: Element, word: string): (label: string) => void {
  const row = append(list, 'li', 'td-mode');
  const paintCap = showText(append(row, 'kbd'));
  const paintShown = showPart(row);
  append(row, 'span', 'td-mode-word', word);
  return (label) => {
    paintShown(label !== '');
    paintCap(label);
  };
}

function createMode(list: Element, word: string): (label: string, on: boolean) => void {
  const row = append(list, 'li', 'td-mode');
  const cap = append(row, 'kbd');
  const paintCap = showText(cap);
  const paintCapShown = showPart(cap);
  append(row, 'span', 'td-mode-word', word);
  const paintState = showText(append(row, 'span', 'td-mode-state'));
  const paintOn = showAttribute(row, 'data-on');
  return (label, on) => {
    paintCapShown(label !== '');
    paintCap(label);
    paintState(on ? 'on' : 'off');
    paintOn(on ? 'true' : 'false');
  };
}
