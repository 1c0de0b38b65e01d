/** Typical mistakes of a page that uses the scene: each is named, by the constructor or by one warning. */
import { describe, expect, it } from 'vitest';
import { createPredictor } from '../../../src/prediction';
import { createSceneView, FINE, type SceneView } from '../../../src/scene';
import { checkedScene } from '../../../src/scene/checks';

const canvas = { getContext: () => null };
const made =
  (...given: readonly unknown[]) =>
  () =>
    (createSceneView as (...given: readonly unknown[]) => SceneView)(...given);

const THROWN: readonly (readonly [what: string, run: () => unknown, help: RegExp])[] = [
  ['no canvas', made(null, FINE), /^canvas: expected a canvas element, got Null/],
  ['a selector for the canvas', made('#scene', FINE), /^canvas: .*String/],
  ['no quality', made(canvas), /^quality: expected qualityFor\(document\).*Undefined/],
  ['the name of a quality', made(canvas, 'fine'), /^quality: .*String/],
  ['a quality without anisotropy', made(canvas, { antialias: true }), /^quality\.anisotropy: .*undefined/],
  ['anisotropy of 0', made(canvas, { ...FINE, anisotropy: 0 }), /^quality\.anisotropy: .*≥ 1, got 0/],
  ['antialias of a text', made(canvas, { ...FINE, antialias: 'yes' }), /^quality\.antialias: .*yes/],
  [
    'a quality’s member that does not exist',
    made(canvas, { ...FINE, shadows: true }),
    /^quality\.shadows: unknown/,
  ],
  ['options of null', made(canvas, FINE, null), /^options: expected an object, got Null/],
  [
    'an option that does not exist',
    made(canvas, FINE, { onWarn: () => 0 }),
    /^options\.onWarn: unknown.*onWarning/,
  ],
  [
    'a listener that is none',
    made(canvas, FINE, { onWarning: console }),
    /^options\.onWarning: expected a function/,
  ],
];

describe('an invalid argument of createSceneView is named', () => {
  it.each(THROWN)('%s', (_what, run, help) => {
    expect(run).toThrow(RangeError);
    expect(run).toThrow(help);
  });
});

/** A scene that notes which calls reach it, and its warnings. */
function watched() {
  const reached: string[] = [];
  const warnings: string[] = [];
  const names = ['screenAxes', 'pixelSize', 'setTerrain', 'setSunElevation', 'draw', 'hasDrawn', 'resize'];
  const all = [...names, 'turnCamera', 'zoomCamera', 'setCamera', 'setMargins', 'resetCamera', 'dispose'];
  const calls = Object.fromEntries(all.map((name) => [name, () => reached.push(name) > 0]));
  const overlays = {
    ghost: false,
    errorSegment: false,
    contactNormal: false,
    footprint: false,
    forces: false,
  };
  const inner = { overlays, markers: { pads: [], touch: null }, ...calls } as unknown as SceneView;
  const scene = checkedScene(inner, (code, message) => warnings.push(`${code}: ${message}`));
  return {
    scene: scene as unknown as Readonly<Record<string, (...given: readonly unknown[]) => unknown>>,
    reached,
    warnings,
  };
}

const view = createPredictor().view(0);

const WRONG: readonly (readonly [call: string, given: readonly unknown[], help: RegExp])[] = [
  ['draw', [null, 1], /^scene-view: draw: expected what predictor\.view returns/],
  ['draw', [1, view], /^scene-view/],
  ['draw', [{ shipId: 'a' }, 1], /^scene-view/],
  ['draw', [view], /^scene-seconds: draw: .*performance\.now/],
  ['draw', [view, NaN], /^scene-seconds/],
  ['draw', [view, 1.8e9], /^scene-seconds/],
  ['setTerrain', ['hills'], /^scene-terrain: .*String/],
  ['setTerrain', [null], /^scene-terrain: .*Null/],
  ['setSunElevation', ['noon'], /^scene-sun: .*degrees.*String/],
  ['setSunElevation', [120], /^scene-sun: .*120/],
  ['resize', [800, 600], /^scene-size: .*devicePixelRatio.*Undefined/],
  ['resize', [0, 600, 1], /^scene-size: .*0, 600, 1/],
  ['turnCamera', [0.1], /^scene-camera-turn: .*rad.*Undefined/],
  ['zoomCamera', [0], /^scene-camera-zoom: .*got 0/],
  ['setMargins', [10], /^scene-margins: .*≥ 0.*10, Undefined/],
  ['setMargins', [-1, 0], /^scene-margins: .*-1, 0/],
  ['setCamera', ['orbit'], /^scene-camera: .*follow, chase.*"orbit"/],
  ['screenAxes', [[]], /^scene-axes: .*nine/],
];

describe('a wrong call of the scene has no effect but one warning', () => {
  it.each(WRONG)('%s %j', (call, given, help) => {
    const { scene, reached, warnings } = watched();
    expect(() => [scene[call]!(...given), scene[call]!(...given)]).not.toThrow();
    expect(reached).toEqual([]);
    expect(warnings).toHaveLength(1);
    expect(warnings[0]).toMatch(help);
  });

  it('after dispose too, and dispose is passed on once', () => {
    const { scene, reached, warnings } = watched();
    scene['dispose']!();
    scene['dispose']!();
    scene['draw']!(view, 1);
    scene['resetCamera']!();
    expect(reached).toEqual(['dispose']);
    expect(warnings).toEqual(['scene-disposed: draw was called after dispose: stop the frame loop first.']);
  });

  it('an overlay that does not exist is named at the next frame', () => {
    const { scene, warnings } = watched();
    Object.assign(scene['overlays'] as object, { trajectory: true });
    scene['draw']!(view, 1);
    expect(warnings[0]).toMatch(/^scene-overlay: overlays\.trajectory: unknown.*footprint/);
  });

  it('right calls all reach the scene, without a warning', () => {
    const { scene, reached, warnings } = watched();
    scene['draw']!(view, 1);
    scene['setTerrain']!(() => 0);
    scene['setSunElevation']!(null);
    scene['setSunElevation']!(-6);
    scene['resize']!(800, 600, 2);
    scene['turnCamera']!(0.1, 0);
    scene['zoomCamera']!(1.2);
    scene['setCamera']!('chase');
    scene['screenAxes']!(new Float64Array(9));
    expect(warnings).toEqual([]);
    expect(reached).toEqual([
      ...['draw', 'setTerrain', 'setSunElevation', 'setSunElevation', 'resize', 'turnCamera', 'zoomCamera'],
      ...['setCamera', 'screenAxes'],
    ]);
  });
});
