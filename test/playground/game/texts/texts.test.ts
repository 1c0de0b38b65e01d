/** Each control that the page names exists on the pilot's device. */
import { describe, expect, it } from 'vitest';
import {
  adviceText,
  controlName,
  type Device,
  howToFly,
} from '../../../../src/playground/game/texts/flightTexts';
import { modeLabelOf } from '../../../../src/playground/game/texts/controlTexts';
import { defaultKeys, KEY_TABLE } from '../../../../src/playground/input/keyTable';
import { createLandingAids, type LandingAids } from '../../../../src/readout';
import { LESSONS, MISSIONS } from '../../../../src/scenarios';
import { makeView } from '../../../readout/views';

const { map } = defaultKeys();

describe.each(['keys', 'gamepad', 'thumbs'] as const)('a pilot with %s', (device) => {
  const cap = (action: keyof typeof map) => map[action];

  it('has a name for every control in a mission’s texts', () => {
    for (const mission of [...MISSIONS, ...LESSONS]) {
      const wanted = [...mission.how.matchAll(/\{(\w+)\}/g)].map(([, action]) => action as keyof typeof map);
      for (const action of wanted) expect([action, controlName(device, action, cap)]).not.toContain('');
      // A name left out leaves its braces out too.
      const text = howToFly(mission, device, cap);
      expect(text).not.toMatch(/ [,.]| {2}/);
      // Devices whose controls have long names have shorter texts.
      if (mission.how !== '' && device === 'keys')
        expect(text.match(/\{[^}]+\}/g) ?? []).toHaveLength(wanted.length);
    }
  });

  it('is told of a lesson in a few words', () => {
    for (const lesson of LESSONS) {
      const most = device === 'thumbs' ? 100 : 300;
      expect(howToFly(lesson, device, cap).length, lesson.scenario.name).toBeLessThan(most);
    }
  });

  it('is named a control for every advice', () => {
    const view = makeView({ clearance: 20 });
    for (const advice of ['more', 'less', 'push'] as const) {
      const text = adviceText({ ...createLandingAids(), advice }, view, device, cap);
      expect([advice, text]).toEqual([advice, expect.stringMatching(/\{.+\}$/)]);
    }
  });

  it('is advised in the display’s words about the speed, and otherwise about what to do', () => {
    const told = (advice: LandingAids['advice'], corridor: LandingAids['corridor']) =>
      adviceText({ ...createLandingAids(), advice, corridor }, makeView(), device, cap)
        .split(/[:{]/)[0]!
        .trim();
    expect([told('more', 'fast'), told('more', 'good')]).toEqual(['Too fast', 'More thrust']);
    expect([told('hold', 'good'), told('hold', 'slow')]).toEqual(['Good speed', 'Keep this thrust']);
    expect([told('less', 'slow'), told('less', 'good')]).toEqual(['Too slow', 'Less thrust']);
    expect([told('push', 'slow'), told('push', 'good')]).toEqual(['Too slow', 'Push down']);
    expect(told('none', 'good')).toBe('');
  });

  it('learns that the tank is empty, and how to begin again', () => {
    const view = makeView({ clearance: 20 }, { fuel: 0, shownState: '' });
    const text = adviceText({ ...createLandingAids(), advice: 'more' }, view, device, cap);
    expect(text).toMatch(
      device === 'thumbs' ? /^Out of fuel: try again$/ : /^Out of fuel: try again \{.+\}$/,
    );
  });

  it('is advised to turn upright first, until the ship turns by itself or the engine pushes more up than sideways', () => {
    const told = (tilt: number, shownState = '', attitudeMode = 'none') => {
      const { own } = makeView();
      const controls = { ...own.controls, attitudeMode: attitudeMode as 'none' };
      const view = makeView({ tilt }, { controls, shownState: shownState as '' });
      return adviceText({ ...createLandingAids(), advice: 'hold', corridor: 'slow' }, view, device, cap);
    };
    expect([told(61), told(150)].map((text) => text.split(' {')[0])).toEqual([
      'Turn upright',
      'Turn upright',
    ]);
    expect(told(61)).toMatch(/\{.+\}$/);
    expect([told(59), told(61, 'contact')]).toEqual(['Keep this thrust', 'Keep this thrust']);
    expect(told(61, '', 'radial')).toBe('');
  });

  it('has a control for all flight actions that keys push and turn with', () => {
    const flown = KEY_TABLE.filter(({ group }) => group === 'Push');
    expect(flown.map(({ action }) => controlName(device, action, cap))).not.toContain('');
  });
});

it('modes are labelled with keys as printed, with buttons of a gamepad, and with nothing beside buttons on the screen', () => {
  const modes = [
    'rateDamping',
    'modeHold',
    'modeUpright',
    'modeRetrograde',
    'autopilot',
    'killRates',
  ] as const;
  const labels = (device: Device) => modes.map((mode) => modeLabelOf(device, mode, (action) => map[action]));
  expect(labels('keys')).toEqual(['KeyT', 'KeyC', 'KeyN', 'KeyB', 'KeyY', 'KeyG']);
  expect(labels('gamepad')).toEqual(['X', '→', '↑', '←', 'Y', '↓']);
  expect(labels('thumbs')).toEqual(['', '', '', '', '', '']);
});
