/** Settings and classes that change while ships fly: by `configure`, or by another hello on the same connection. */
import { describe, expect, it } from 'vitest';
import { SHIP_CLASSES } from '../../../src/dynamics';
import type { Hello } from '../../../src/wire';
import { createRig } from '../rig';

const distance = (a: ArrayLike<number>, b: ArrayLike<number>) =>
  Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);

/** A bounce at 10 Hz, after three seconds, on a server that does not send its settings. */
function flying(secretSettings: object = {}) {
  const rig = createRig({ scenario: 'bounce', tickRate: 10, secretSettings, others: 2 });
  rig.fly(1.5);
  return rig;
}

/** A frame after `change` the ship is drawn where its motion leads in that frame. */
function goesOn(rig: ReturnType<typeof flying>, change: () => void): void {
  const { own, ships } = rig.view();
  const place = [...own!.easedPosition];
  const count = ships.length;
  const { framesAccepted } = rig.view().diagnosis;
  change();
  const after = rig.frame();
  expect(after.ships).toHaveLength(count);
  expect(after.ready).toBe(true);
  expect(after.diagnosis.framesAccepted).toBeGreaterThanOrEqual(framesAccepted);
  const way = Math.hypot(...after.own!.velocity) / 60;
  expect(distance(place, after.own!.easedPosition)).toBeLessThan(1.2 * way + 0.05);
}

const land = (rig: ReturnType<typeof flying>) => {
  rig.fly(0.5);
  const before = rig.view().diagnosis.correctionsMismatch;
  rig.fly(25);
  const { own, diagnosis } = rig.view();
  expect([own!.shownState, own!.provenance]).toEqual(['landed', 'confirmed']);
  return diagnosis.correctionsMismatch - before;
};

describe('settings that change at run time', () => {
  it.each([[{ contactBounceSpeed: 3 }], [{ contactLongestSubstep: 0.005 }], [{ contactDampingRatio: 0.5 }]])(
    'by configure: ships stay and agree with a server that has the same settings: %j',
    (settings) => {
      const rig = flying(settings);
      goesOn(rig, () => {
        expect(rig.predictor.configure({ settings })).toEqual({ ok: true, value: null });
      });
      expect(rig.view().settings).toMatchObject(settings);
      expect(land(rig)).toBe(0);
    },
  );

  it('by a hello on the same connection', () => {
    const settings = { contactLongestSubstep: 0.005 };
    const rig = createRig({ scenario: 'bounce', tickRate: 10, secretSettings: settings, others: 2 });
    let hello: Hello | null = null;
    const { tamper } = rig;
    rig.tamper = (message) => {
      const messages = tamper(message);
      for (const one of messages) if (one.kind === 'hello') hello = one;
      return messages;
    };
    rig.fly(1.5);
    goesOn(rig, () => {
      const { tick } = rig.view();
      rig.predictor.receive({ ...hello!, tick, settings: { ...hello!.settings, ...settings } }, rig.now);
    });
    expect(rig.view().settings).toMatchObject(settings);
    expect(land(rig)).toBe(0);
  });
});

describe('ship classes that change at run time', () => {
  const classOf = (rig: ReturnType<typeof flying>) => rig.view().own!.shipClass;

  it('in another order are the same classes', () => {
    const rig = flying();
    const { name } = classOf(rig);
    goesOn(rig, () => rig.predictor.configure({ shipClasses: SHIP_CLASSES.toReversed() }));
    expect(classOf(rig).name).toBe(name);
    expect(land(rig)).toBe(0);
  });

  it('with other numbers apply from the newest state on', () => {
    const rig = flying();
    const { name } = classOf(rig);
    const heavier = SHIP_CLASSES.map((one) =>
      one.name === name ? { ...one, dryMass: one.dryMass * 2 } : one,
    );
    goesOn(rig, () => rig.predictor.configure({ shipClasses: heavier }));
    expect(classOf(rig).dryMass).toBe(heavier.find((one) => one.name === name)!.dryMass);
  });

  it('that miss a ship’s class leave it drawn from its states until the class is back', () => {
    const rig = flying();
    const { name } = classOf(rig);
    rig.predictor.configure({ shipClasses: SHIP_CLASSES.filter((one) => one.name !== name) });
    rig.frame();
    rig.fly(0.3);
    expect(rig.view().own!.provenance).toBe('off');
    rig.predictor.configure({ shipClasses: SHIP_CLASSES });
    rig.fly(0.5);
    expect(rig.view().own!.provenance).not.toBe('off');
    expect(land(rig)).toBe(0);
  });
});

it('an invalid change is refused by field, and nothing changes', () => {
  const rig = flying();
  const { settings } = rig.view();
  for (const [changes, reason] of [
    [{ settings: { contactCrashSpeed: -1 } }, 'configure: settings.contactCrashSpeed'],
    [{ terrain: 'mars' }, 'configure: terrain: no terrain named mars'],
    [{ shipClasses: [{}] }, 'configure: '],
    [{ bodies: 7 }, 'configure: '],
    [null, 'configure: expected an object'],
    [7, 'configure: expected an object'],
  ] as const) {
    expect(rig.predictor.configure(changes as object)).toEqual({
      ok: false,
      reason: expect.stringContaining(reason) as string,
    });
    rig.frame();
    expect(rig.view().settings, reason).toBe(settings);
  }
  expect(land(rig)).toBe(0);
});

it('before the first frame, a valid change applies from the first frame on', () => {
  const rig = createRig({ scenario: 'bounce', tickRate: 10, legacy: true });
  rig.predictor.configure({ settings: { contactCrashSpeed: 99 } });
  rig.fly(2);
  expect(rig.view().settings.contactCrashSpeed).toBe(99);
});
