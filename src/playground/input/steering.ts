import { type RotationAction, toBodyAxes, type TranslationAction } from '../../readout';

/**
 * Stick directions as the camera sees them, in ship axes: "tilt away" tips the ship's top away from the eye whatever its heading.
 * Rows of three: the axes that pitch + and yaw + turn about, then where the pushes x, y and z + point.
 */
export interface SteeringAxes {
  readonly axes: Float64Array;
  /** Share of full torque that a key gives: a lander at full torque turns too fast to be flown by keys. */
  gain: number;
}

/** Key torque in flight: 0.5 rad/s² for the lander. On the ground, righting a ship takes full torque. */
const FLIGHT_GAIN = 0.35;

export function createSteeringAxes(): SteeringAxes {
  return { axes: Float64Array.from(SHIP_AXES), gain: 1 };
}

const SHIP_AXES = [1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1];

const row = new Float64Array(3);

/**
 * @param screen right, away and up in ICRF, nine numbers; null: the ship's own axes
 * @param attitude of the ship, [x, y, z, w]
 */
export function alignSteeringAxes(
  out: SteeringAxes,
  screen: Float64Array | null,
  attitude: Float64Array,
  flying: boolean,
): void {
  out.gain = flying ? FLIGHT_GAIN : 1;
  if (screen === null) {
    out.axes.set(SHIP_AXES);
    return;
  }
  for (let i = 0; i < 3; i++) {
    row.set(screen.subarray(3 * i, 3 * i + 3));
    toBodyAxes(row, attitude, row);
    out.axes.set(row, 6 + 3 * i);
  }
  for (let k = 0; k < 3; k++) {
    out.axes[k] = out.axes[6 + k]!;
    // About the away axis a positive turn tips to the right; yaw + is to the left.
    out.axes[3 + k] = -out.axes[9 + k]!;
  }
}

type Triple = [number, number, number];

/** Sine of the angle below which an axis of the screen lies along the thrust axis, so that a tilt about it has no effect. */
const BESIDE = 0.1;

/** Hundredths: finer steps cannot be felt and need not be in a link. */
const STEPS = 100;

/** Rotation input of stick deflections: pitch + towards the eye, yaw + to the left, `z` about the thrust axis. */
export function turnInput({ axes, gain }: SteeringAxes, x: number, y: number, z: number): Triple {
  // A tilt never rolls: of a ship that lies on its side the screen's axes have a share along its own.
  const out: Triple = [x * axes[0]! + y * axes[3]!, x * axes[1]! + y * axes[4]!, 0];
  const has = Math.hypot(out[0], out[1]) > BESIDE * Math.hypot(x, y);
  spread(out, has ? Math.min(Math.hypot(x, y), 1) * gain : 0);
  out[2] = clamp(z * gain);
  return rounded(out);
}

/** Translation input of pushes to the right, away and up. */
export function pushInput({ axes }: SteeringAxes, right: number, away: number, up: number): Triple {
  const out: Triple = [0, 0, 0];
  for (let k = 0; k < 3; k++) out[k] = right * axes[6 + k]! + away * axes[9 + k]! + up * axes[12 + k]!;
  spread(out, Math.min(Math.hypot(right, away, up), 1));
  return rounded(out);
}

/** Keeps the direction; the largest part becomes `size`. */
function spread(out: Triple, size: number): void {
  const largest = Math.max(Math.abs(out[0]), Math.abs(out[1]), Math.abs(out[2]));
  if (largest === 0) return;
  for (let k = 0; k < 3; k++) out[k] = (out[k]! / largest) * size;
}

function clamp(value: number): number {
  return Math.min(Math.max(value, -1), 1);
}

function rounded([x, y, z]: Triple): Triple {
  const round = (value: number) => Math.round(value * STEPS) / STEPS + 0;
  return [round(x), round(y), round(z)];
}

/** cos 22.5°. */
const ALONE = 0.924;
/** cos 67.5°: a second key whose direction is at least this far along helps. */
const HELPS = 0.383;

/** The keys that turn the ship about one of its axes, the better one first, for hints. */
export function turnKeysFor({ axes }: SteeringAxes, aboutX: number, aboutY: number): RotationAction[] {
  const length = Math.hypot(aboutX, aboutY) || 1;
  const along = (i: number) => (aboutX * axes[3 * i]! + aboutY * axes[3 * i + 1]!) / length;
  const pitch = along(0);
  const yaw = along(1);
  const keys: (readonly [number, RotationAction])[] = [
    [pitch, 'pitchPlus'],
    [-pitch, 'pitchMinus'],
    [yaw, 'yawPlus'],
    [-yaw, 'yawMinus'],
  ];
  // One key if it turns the ship nearly that way; otherwise two together.
  const isAlone = (share: number, i: number) =>
    share > HELPS && share > ALONE * Math.hypot(axes[i < 2 ? 0 : 3]!, axes[i < 2 ? 1 : 4]!);
  const alone = keys.filter(([share], i) => isAlone(share, i)).sort(([a], [b]) => b - a);
  const helping = keys.filter(([share]) => share > HELPS).sort(([a], [b]) => b - a);
  const best = alone.length > 0 ? alone.slice(0, 1) : helping;
  return (best.length > 0 ? best : keys.sort(([a], [b]) => b - a).slice(0, 1)).map(([, key]) => key);
}

/** The push key whose direction is nearest to a ship axis. */
export function pushKeyFor({ axes }: SteeringAxes, action: TranslationAction): TranslationAction {
  const axis = { X: 0, Y: 1, Z: 2 }[action.charAt(9) as 'X' | 'Y' | 'Z'];
  const isPlus = action.endsWith('Plus');
  const keys = ['translateX', 'translateY', 'translateZ'] as const;
  let best: TranslationAction = action;
  let most = 0;
  keys.forEach((key, i) => {
    const share = axes[6 + 3 * i + axis]!;
    if (Math.abs(share) <= most) return;
    most = Math.abs(share);
    best = `${key}${share > 0 === isPlus ? 'Plus' : 'Minus'}`;
  });
  return best;
}
