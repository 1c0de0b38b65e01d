/** Mistakes in options, settings and terrains: the mistake, the expected code, and a part of the expected message. */
import { SHIP_CLASSES } from '../../../../src/dynamics';
import { type Mistake, frames, ground, hello, LUNA, made, warningsOf } from './given';

const classes = (changes: object) => ({
  defaults: { shipClasses: [{ ...SHIP_CLASSES[2]!, ...changes }] },
});

export const OPTIONS: readonly Mistake[] = [
  ['ownShipID', 'unknown-option', /mean ownShipId/, () => made({ ownShipID: 'a' })],
  ['shipId for ownShipId', 'unknown-option', /mean ownShipId/, () => made({ shipId: 'a' })],
  ['on_warning', 'unknown-option', /mean onWarning/, () => made({ on_warning: () => undefined })],
  ['budget', 'unknown-option', /Known:/, () => made({ budget: 1 })],
  [
    'smoothing.alongground',
    'unknown-option',
    /mean alongGround/,
    () => made({ smoothing: { alongground: 1 } }),
  ],
  ['defaults.terrains', 'unknown-default', /mean terrain/, () => made({ defaults: { terrains: 'flat' } })],
  [
    'defaults.ship_classes',
    'unknown-default',
    /mean shipClasses/,
    () => made({ defaults: { ship_classes: [] } }),
  ],
  [
    'settings in snake_case',
    'unknown-setting',
    /mean contactCrashSpeed/,
    () => made({ defaults: { settings: { contact_crash_speed: 60 } } }),
  ],
  [
    'a made-up setting',
    'unknown-setting',
    /no effect/,
    () => made({ defaults: { settings: { gravity: 2 } } }),
  ],
  [
    'an angle in radians',
    'setting-in-radians',
    /degrees/,
    () => made({ defaults: { settings: { contactTippedAngleDeg: 1.4, contactSettleTiltDeg: 0.4 } } }),
  ],

  [
    'a small angle in radians',
    'setting-in-radians',
    /contactSettleTiltDeg is 0\.087: degrees/,
    () => made({ defaults: { settings: { contactSettleTiltDeg: 0.087 } } }),
  ],
  [
    'a speed in km/s',
    'setting-in-kilometres',
    /m\/s/,
    () => made({ defaults: { settings: { contactCrashSpeed: 0.05, contactBounceSpeed: 0.01 } } }),
  ],
  ['a class in snake_case', 'unknown-class-field', /mean dryMass/, () => made(classes({ dry_mass: 8000 }))],
  ['thrust in kN', 'class-units', /not kN/, () => made(classes({ mainEngineThrust: 200 }))],
  ['masses in t', 'class-units', /not t/, () => made(classes({ dryMass: 8, fuelCapacity: 8 }))],
  [
    'a radius in km',
    'body-density',
    /radius in m/,
    () => made({ defaults: { bodies: [{ ...LUNA, radius: 1737.4 }] } }),
  ],
  ['a setting in the options themselves', 'unknown-option', /Known:/, () => made({ contactCrashSpeed: 60 })],
  [
    'a made-up setting in configure',
    'unknown-setting',
    /no effect/,
    () => warningsOf((p) => p.configure({ settings: { gravity: 2 } as object })),
  ],
  [
    'terrain in configure misspelt',
    'unknown-default',
    /mean terrain/,
    () => warningsOf((p) => p.configure({ terrains: 'flat' } as object)),
  ],
  [
    'a terrain given and not named',
    'terrain-unused',
    /defaults\.terrain/,
    () => frames({ terrains: { moon: () => 0 } }),
  ],
  [
    'a terrain under another name than the hello’s',
    'terrain-unused',
    /moon/,
    () => frames({ terrains: { moon: () => 0 } }, hello),
  ],
  [
    'a terrain that returns nothing',
    'terrain-unusable',
    /undefined.*metres/,
    () => frames(ground(() => undefined)),
  ],
  ['a terrain that returns NaN', 'terrain-unusable', /NaN.*metres/, () => frames(ground(() => NaN))],
  ['a terrain that returns a string', 'terrain-unusable', /"3".*metres/, () => frames(ground(() => '3'))],
  [
    'a terrain that returns a promise',
    'terrain-unusable',
    /Promise.*null/,
    () => frames(ground(() => Promise.resolve(3))),
  ],
  [
    'a terrain that throws',
    'terrain-unusable',
    /Error.*not loaded/,
    () =>
      frames(
        ground(() => {
          throw new Error('no tile');
        }),
      ),
  ],
  [
    'a terrain that returns the radius',
    'terrain-too-high',
    /not the radius/,
    () => frames(ground(() => 1_737_400)),
  ],
  [
    'configure with a setting that is invalid',
    'configure-refused',
    /contactCrashSpeed/,
    () => warningsOf((p) => p.configure({ settings: { contactCrashSpeed: -1 } })),
  ],
  [
    'configure with a terrain that is not there',
    'configure-refused',
    /mars/,
    () => warningsOf((p) => p.configure({ terrain: 'mars' })),
  ],
];
