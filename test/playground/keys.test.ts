import { describe, expect, it } from 'vitest';
import { NEUTRAL_CONTROLS } from '../../src/dynamics';
import { actionOf } from '../../src/playground/input/keyboard';
import {
  defaultKeys,
  firstDoubled,
  isBindable,
  KEY_TABLE,
  loadKeys,
  rebind,
  saveKeys,
} from '../../src/playground/input/keyTable';
import { createStick, press, release, resetStick, sampleStick } from '../../src/playground/input/stick';

/** A store in memory. */
function storeWith(text: string | null): Storage {
  let kept = text;
  return {
    getItem: () => kept,
    setItem: (_: string, value: string) => {
      kept = value;
    },
  } as unknown as Storage;
}

describe('key table', () => {
  it('has the game’s keys, each once, none with a modifier', () => {
    const { map } = defaultKeys();
    expect(firstDoubled(map)).toBeNull();
    expect(KEY_TABLE.every(({ key }) => isBindable(key))).toBe(true);
    expect([map.throttleUp, map.throttleDown, map.throttleFull, map.throttleCut]).toEqual([
      'f',
      'v',
      'z',
      'x',
    ]);
    expect([map.rateDamping, map.restart, map.pause, map.stepSubstep]).toEqual(['t', 'r', 'p', 'o']);
    expect([map.previousScenario, map.nextScenario, map.hide, map.help]).toEqual(['[', ']', 'h', '?']);
    const turns = ['pitchPlus', 'pitchMinus', 'yawPlus', 'yawMinus', 'rollPlus', 'rollMinus'] as const;
    expect(turns.map((action) => map[action]).sort()).toEqual(['a', 'd', 'e', 'q', 's', 'w']);
  });

  it('is remapped by exchange, saved and read again', () => {
    const { map } = defaultKeys();
    const next = rebind(map, 'pitchPlus', 'w');
    expect([next.pitchPlus, next.pitchMinus]).toEqual(['w', 's']);
    const store = storeWith(null);
    saveKeys(store, { map: next, enabled: false });
    expect(loadKeys(store)).toEqual({ map: next, enabled: false });
    expect(actionOf({ map: next, enabled: true }, 'W')).toBe('pitchPlus');
    expect(actionOf({ map: next, enabled: false }, 'w')).toBeNull();
  });

  it.each([
    ['not JSON', '{'],
    ['no object', '7'],
    ['a map of nonsense', '{"map":{"pitchPlus":"Enter","yawPlus":9,"nothing":"k"}}'],
    ['two actions on a key', '{"map":{"pitchPlus":"w"}}'],
    ['no map', '{"map":null}'],
  ])('%s in the store leaves the defaults', (_, text) => {
    expect(loadKeys(storeWith(text))).toEqual(defaultKeys());
  });

  it('does without a store that refuses', () => {
    const refusing = {
      getItem: () => {
        throw new Error('forbidden');
      },
      setItem: () => {
        throw new Error('full');
      },
    } as unknown as Storage;
    expect(loadKeys(refusing)).toEqual(defaultKeys());
    saveKeys(refusing, defaultKeys());
    expect(loadKeys(null)).toEqual(defaultKeys());
  });
});

describe('stick', () => {
  it('gives the same controls object while nothing changes', () => {
    const stick = createStick();
    press(stick, 'pitchPlus', NEUTRAL_CONTROLS);
    const first = sampleStick(stick, 0.016);
    expect(first.rotationInput).toEqual([1, 0, 0]);
    expect(sampleStick(stick, 0.016)).toBe(first);
    release(stick, 'pitchPlus');
    expect(sampleStick(stick, 0.016).rotationInput).toEqual([0, 0, 0]);
  });

  it('moves the throttle while its key is held, and stops at its ends', () => {
    const stick = createStick();
    press(stick, 'throttleUp', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.5).thrustLevel).toBeCloseTo(0.3, 12);
    expect(sampleStick(stick, 5).thrustLevel).toBe(1);
    release(stick, 'throttleUp');
    press(stick, 'throttleCut', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.016).thrustLevel).toBe(0);
  });

  it('takes over what the scenario’s own pilot was doing, and forgets it at a restart', () => {
    const stick = createStick();
    press(stick, 'yawMinus', { ...NEUTRAL_CONTROLS, thrustLevel: 0.7, attitudeHold: true });
    const taken = sampleStick(stick, 0.016);
    expect([taken.thrustLevel, taken.attitudeHold, taken.rotationInput]).toEqual([0.7, true, [0, -1, 0]]);
    press(stick, 'yawPlus', NEUTRAL_CONTROLS);
    expect(sampleStick(stick, 0.016).rotationInput).toEqual([0, 0, 0]);
    resetStick(stick);
    expect([stick.touched, stick.controls]).toEqual([false, NEUTRAL_CONTROLS]);
  });
});
