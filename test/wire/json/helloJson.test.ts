import { expect, it } from 'vitest';
import { BODIES, DEFAULT_SETTINGS, NEUTRAL_CONTROLS, SHIP_CLASSES } from '../../../src/dynamics';
import { decodeControlsJson, decodeHelloJson, encodeControlsJson, encodeHelloJson } from '../../../src/wire';
import { HELLO, INPUT } from '../messages';

const throughText = (value: unknown): unknown => JSON.parse(JSON.stringify(value));

it('survives a round trip', () => {
  expect(decodeHelloJson(throughText(encodeHelloJson(HELLO)))).toEqual({
    ok: true,
    value: { ...HELLO, refusals: [] },
  });
});

it('uses the design’s defaults for absent settings', () => {
  expect(decodeHelloJson({ playerId: 'p', ship_id: 's', tickRate: '10', time_scale: null })).toEqual({
    ok: true,
    value: {
      kind: 'hello',
      protocolVersion: '1.0',
      playerId: 'p',
      shipId: 's',
      settings: DEFAULT_SETTINGS,
      shipClasses: SHIP_CLASSES,
      bodies: BODIES,
      terrain: 'flat',
      tick: 0,
      tickRate: 10,
      timeScale: 1,
      inputGranularity: 'tick',
      refusals: [],
    },
  });
});

it('accepts an inertia tensor as a list of rows', () => {
  const { ship_classes: classes } = throughText(encodeHelloJson(HELLO)) as { ship_classes: object[] };
  const { inertiaTensor } = HELLO.shipClasses[0]!;
  const rows = { ship_classes: [{ ...classes[0], inertia_tensor: inertiaTensor }] };
  expect(decodeHelloJson(rows)).toMatchObject({ ok: true, value: { shipClasses: HELLO.shipClasses } });
  const two = { ship_classes: [{ ...classes[0], inertia_tensor: inertiaTensor.slice(1) }] };
  expect(decodeHelloJson(two)).toMatchObject({
    ok: true,
    value: { refusals: ['ship_classes[0].inertia_tensor: expected an object, got a list of 2'] },
  });
});

it('lists invalid classes and bodies, and refuses an invalid setting by name', () => {
  const { ship_classes: classes } = throughText(encodeHelloJson(HELLO)) as { ship_classes: object[] };
  const decoded = decodeHelloJson({
    ship_classes: [classes[0], { ...classes[0], name: 'b', dry_mass: 0 }],
    bodies: { Nowhere: {} },
    settings: { contactCrashSpeed: 40 },
  });
  expect(decoded).toMatchObject({
    ok: true,
    value: {
      settings: { contactCrashSpeed: 40 },
      shipClasses: [HELLO.shipClasses[0]],
      bodies: [],
      refusals: [
        'ship_classes[1].dry_mass: expected ≥ 0.001 kg, got 0',
        expect.stringMatching(/^bodies\["Nowhere"\]\./),
      ],
    },
  });
  expect(decodeHelloJson({ settings: { contact_crash_speed: -1 } })).toMatchObject({
    ok: false,
    reason: expect.stringMatching(/^settings\.contact_/) as string,
  });
  expect(decodeHelloJson('welcome')).toMatchObject({ ok: false });
});

it('survives a round trip of controls, and clamps and refuses as protobuf does', () => {
  const { controls } = INPUT;
  expect(encodeControlsJson(controls)).toEqual({
    thrust_level: 0.5,
    translation_input: { x: 0.5, y: -0.25, z: 1 },
    rotation_input: { x: 0.75, y: -1, z: 0.5 },
    attitude_hold: true,
    attitude_mode: 'hold',
    target_attitude: { w: -0.5, x: 0.5, y: 0.5, z: 0.5 },
  });
  expect(decodeControlsJson(throughText(encodeControlsJson(controls)))).toEqual({
    ok: true,
    value: controls,
  });
  expect(decodeControlsJson({})).toEqual({ ok: true, value: NEUTRAL_CONTROLS });
  expect(decodeControlsJson({ thrustLevel: 7, rotation_input: '[0, 2, 0]' })).toMatchObject({
    ok: true,
    value: { thrustLevel: 1, rotationInput: [0, 1, 0] },
  });
  expect(decodeControlsJson({ thrust_level: 'NaN' })).toEqual({
    ok: false,
    reason: 'controls.thrust_level: expected a finite number, got "NaN"',
  });
});
