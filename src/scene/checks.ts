import { requireKnown } from '../dynamics';
import { CAMERA_VIEWS } from './camera/cameras';
import type { Quality } from './quality';
import type { SceneView } from './sceneView';

/** Called once per code with a caller's mistake and advice. */
export type SceneWarn = (code: string, message: string) => void;

/** Options of a scene view. */
export interface SceneOptions {
  /** Called once for each mistake in a call (ERRORS). The call has no effect. */
  readonly onWarning?: SceneWarn;
}

/** 'Null', 'Undefined', 'String', 'HTMLDivElement', … */
const kindOf = (value: unknown): string => Object.prototype.toString.call(value).slice(8, -1);
const isRecord = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null;

/** @throws RangeError that names the invalid argument or option */
export function requireScene(canvas: HTMLCanvasElement, quality: Quality, options: SceneOptions): void {
  if (typeof (canvas as HTMLCanvasElement | undefined | null)?.getContext !== 'function')
    throw new RangeError(`canvas: expected a canvas element, got ${kindOf(canvas)}`);
  if (!isRecord(quality))
    throw new RangeError(`quality: expected qualityFor(document) or FINE, got ${kindOf(quality)}`);
  const { antialias, anisotropy }: Partial<Quality> = quality;
  if (typeof antialias !== 'boolean')
    throw new RangeError(`quality.antialias: expected true or false, got ${String(antialias)}`);
  if (typeof anisotropy !== 'number' || !(anisotropy >= 1))
    throw new RangeError(`quality.anisotropy: expected a number ≥ 1, got ${String(anisotropy)}`);
  requireKnown('quality', ['antialias', 'anisotropy'], quality);
  if (!isRecord(options)) throw new RangeError(`options: expected an object, got ${kindOf(options)}`);
  const { onWarning }: SceneOptions = options;
  if (onWarning !== undefined && typeof onWarning !== 'function')
    throw new RangeError(`options.onWarning: expected a function, got ${kindOf(onWarning)}`);
  requireKnown('options', ['onWarning'], options);
}

/** s: no monotonic clock has run for 30 years; Unix time has. */
const UNIX_TIME = 1e9;

const areFinite = (...values: readonly unknown[]): boolean => values.every(Number.isFinite);
const areAbove = (...values: readonly unknown[]): boolean =>
  values.every((value) => Number.isFinite(value) && (value as number) > 0);

const isView = (view: unknown): boolean =>
  isRecord(view) && Array.isArray(view['ships']) && Array.isArray(view['bodies']);
const isDegrees = (value: unknown): boolean => areFinite(value) && Math.abs(value as number) <= 90;

const OVERLAYS: readonly (keyof SceneView['overlays'])[] = [
  'ghost',
  'errorSegment',
  'contactNormal',
  'footprint',
  'forces',
];

/** Frames between two checks of the caller's overlays. */
const LOOKS = 60;

/** A number as it is, anything else by its kind. */
const shown = (value: unknown): string => (typeof value === 'number' ? String(value) : kindOf(value));

/** Decides whether calls are carried out, and warns where not. */
interface Guard {
  readonly warn: SceneWarn;
  readonly isOpen: (call: string) => boolean;
  readonly allows: (call: string, isValid: boolean, code: string, expected: string) => boolean;
  /** Returns whether this was the first time. */
  readonly end: () => boolean;
}

function createGuard(onWarning: SceneWarn | undefined): Guard {
  const reported = new Set<string>();
  let isDisposed = false;
  const warn: SceneWarn = (code, message) => {
    if (reported.has(code)) return;
    reported.add(code);
    onWarning?.(code, message);
  };
  const isOpen = (call: string): boolean => {
    if (isDisposed) warn('scene-disposed', `${call} was called after dispose: stop the frame loop first.`);
    return !isDisposed;
  };
  return {
    warn,
    isOpen,
    allows(call, isValid, code, expected) {
      if (!isValid) warn(code, `${call}: expected ${expected}. The call has no effect.`);
      return isOpen(call) && isValid;
    },
    end() {
      const isFirst = !isDisposed;
      isDisposed = true;
      return isFirst;
    },
  };
}

/** Wraps a scene view: a call with an invalid argument, or after `dispose`, only causes a warning. */
export function checkedScene(scene: SceneView, onWarning: SceneWarn | undefined): SceneView {
  const guard = createGuard(onWarning);
  const { allows, isOpen } = guard;
  let draws = 0;
  return {
    overlays: scene.overlays,
    markers: scene.markers,
    translucent: scene.translucent,
    ...cameraCalls(scene, guard),
    hasDrawn: () => isOpen('hasDrawn') && scene.hasDrawn(),
    draw(view, seconds) {
      if (!allows('draw', isView(view), 'scene-view', 'what predictor.view returns, then seconds')) return;
      const isTime = areFinite(seconds) && seconds < UNIX_TIME;
      if (!allows('draw', isTime, 'scene-seconds', 'monotonic seconds, performance.now() / 1000')) return;
      if (draws++ % LOOKS === 0) checkOverlays(scene, guard.warn);
      scene.draw(view, seconds);
    },
    setTerrain(terrain) {
      const expected = `a function (bodyName, nx, ny, nz) → metres above the radius, got ${shown(terrain)}`;
      if (allows('setTerrain', typeof terrain === 'function', 'scene-terrain', expected))
        scene.setTerrain(terrain);
    },
    setSunElevation(elevation) {
      const expected = `degrees from −90 to 90, or null, got ${shown(elevation)}`;
      if (allows('setSunElevation', elevation === null || isDegrees(elevation), 'scene-sun', expected))
        scene.setSunElevation(elevation);
    },
    resize(width, height, ratio) {
      const got = [width, height, ratio].map(shown).join(', ');
      const expected = `width and height in CSS pixels, and devicePixelRatio, all above 0, got ${got}`;
      if (allows('resize', areAbove(width, height, ratio), 'scene-size', expected))
        scene.resize(width, height, ratio);
    },
    dispose() {
      if (guard.end()) scene.dispose();
    },
  };
}

function cameraCalls(scene: SceneView, { allows, isOpen }: Guard) {
  return {
    screenAxes: (out) =>
      allows('screenAxes', out instanceof Float64Array && out.length >= 9, 'scene-axes', 'nine doubles') &&
      scene.screenAxes(out),
    pixelSize: () => (isOpen('pixelSize') ? scene.pixelSize() : Number.NaN),
    turnCamera(azimuth, elevation) {
      const expected = `two angles, rad, got ${shown(azimuth)}, ${shown(elevation)}`;
      if (allows('turnCamera', areFinite(azimuth, elevation), 'scene-camera-turn', expected))
        scene.turnCamera(azimuth, elevation);
    },
    zoomCamera(factor) {
      if (allows('zoomCamera', areAbove(factor), 'scene-camera-zoom', `a factor > 0, got ${shown(factor)}`))
        scene.zoomCamera(factor);
    },
    setCamera(camera) {
      const expected = `one of ${CAMERA_VIEWS.join(', ')}, got ${JSON.stringify(camera)}`;
      if (allows('setCamera', CAMERA_VIEWS.includes(camera), 'scene-camera', expected))
        scene.setCamera(camera);
    },
    setMargins(top, bottom) {
      const expected = `two numbers ≥ 0, CSS pixels, got ${shown(top)}, ${shown(bottom)}`;
      if (
        allows('setMargins', areFinite(top, bottom) && Math.min(top, bottom) >= 0, 'scene-margins', expected)
      )
        scene.setMargins(top, bottom);
    },
    resetCamera: () => (isOpen('resetCamera') ? scene.resetCamera() : undefined),
  } satisfies Partial<SceneView>;
}

function checkOverlays({ overlays }: SceneView, warn: SceneWarn): void {
  const unknown = Object.keys(overlays).filter((name) => !(OVERLAYS as readonly string[]).includes(name));
  if (unknown.length > 0)
    warn('scene-overlay', `overlays.${unknown.join(', ')}: unknown. Known: ${OVERLAYS.join(', ')}.`);
}
