/** Options, settings and terrains: what was done, the expected code, and a part of the expected message. */
import { type Mistake, frames, ground, hello, made, warningsOf } from './given';

export const OPTIONS: readonly Mistake[] = [
  ['ownShipID', 'unknown-option', /mean ownShipId/, () => made({ ownShipID: 'a' })],
  ['shipId for ownShipId', 'unknown-option', /mean ownShipId/, () => made({ shipId: 'a' })],
  ['on_warning', 'unknown-option', /mean onWarning/, () => made({ on_warning: () => undefined })],
  ['budget', 'unknown-option', /Known are/, () => made({ budget: 1 })],
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
    () => made({ defaults: { settings: { contactTippedAngleDeg: 1.4, contactSettleTiltDeg: 0.1 } } }),
  ],

  [
    'a setting in the options themselves',
    'unknown-option',
    /Known are/,
    () => made({ contactCrashSpeed: 60 }),
  ],
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
  ['a terrain that returns a text', 'terrain-unusable', /"3".*metres/, () => frames(ground(() => '3'))],
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
