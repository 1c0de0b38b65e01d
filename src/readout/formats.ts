/**
 * Numbers as a pilot reads them. Every format has two halves, so that a painter can detect a visible change
 * without building a string: `…Key` rounds to the resolution shown, and the text is made from the key alone.
 */

/** Shown for a number that is unknown or has no meaning now. */
export const DASHES = '--';

export interface Format {
  /** The value rounded to what is shown; NaN stays NaN and shows as dashes. */
  readonly key: (value: number) => number;
  /** The text of a key. */
  readonly text: (key: number) => string;
}

/** Vertical speed, m/s, positive = descending: `↓ 12.3 m/s`. */
export const VERTICAL_SPEED: Format = {
  key: (value) => steps(value, 10),
  text: (key) => {
    if (Number.isNaN(key)) return DASHES;
    const arrow = key > 0 ? '↓ ' : key < 0 ? '↑ ' : '';
    return `${arrow}${tenths(Math.abs(key))} m/s`;
  },
};

/** Speed, m/s: `4.5 m/s`. */
export const SPEED: Format = {
  key: (value) => steps(value, 10),
  text: (key) => (Number.isNaN(key) ? DASHES : `${tenths(key)} m/s`),
};

/** Height or distance, m: tenths below 100 m, whole metres below 10 km, then tenths of a kilometre. */
export const DISTANCE: Format = {
  key: (value) => {
    const size = Math.abs(value);
    if (size < 99.95) return steps(value, 10);
    return size < 9999.5 ? Math.round(value) * 10 : Math.round(value / 100) * 1000;
  },
  text: (key) => {
    if (Number.isNaN(key)) return DASHES;
    const metres = key / 10;
    if (Math.abs(metres) < 100) return `${tenths(key)} m`;
    return Math.abs(metres) < 10_000 ? `${grouped(metres)} m` : `${tenths(metres / 100)} km`;
  },
};

/** Time, s: `4.2 s`, from 100 s `2 min 05 s`. */
export const DURATION: Format = {
  key: (value) => (value < 99.95 ? steps(value, 10) : Math.round(value) * 10),
  text: (key) => {
    if (Number.isNaN(key)) return DASHES;
    if (key < 1000) return `${tenths(key)} s`;
    const seconds = Math.round(key / 10);
    if (seconds >= 5999.5) return '> 99 min';
    return `${String(Math.floor(seconds / 60))} min ${String(seconds % 60).padStart(2, '0')} s`;
  },
};

/** Angle, degrees: `12.4°`. */
export const ANGLE: Format = {
  key: (value) => steps(value, 10),
  text: (key) => (Number.isNaN(key) ? DASHES : `${tenths(key)}°`),
};

/** Rate of turn, rad/s, thousandths: the settle gate is 0.01. */
export const SPIN: Format = {
  key: (value) => steps(value, 1000),
  text: (key) => (Number.isNaN(key) ? DASHES : `${(key / 1000).toFixed(3)} rad/s`),
};

/** Speed at a gate, m/s, hundredths. */
export const FINE_SPEED: Format = {
  key: (value) => steps(value, 100),
  text: (key) => (Number.isNaN(key) ? DASHES : `${(key / 100).toFixed(2)} m/s`),
};

/** Torque, N m in, kN m out, two or three digits. */
export const TORQUE: Format = {
  key: (value) => (Math.abs(value) < 99_950 ? Math.round(value / 100) : Math.round(value / 1000) * 10),
  text: (key) => {
    if (Number.isNaN(key)) return DASHES;
    return `${key < 1000 ? tenths(key) : grouped(key / 10)} kN m`;
  },
};

/** Fuel, kg. */
export const MASS: Format = {
  key: (value) => (value < 99.95 ? steps(value, 10) : Math.round(value) * 10),
  text: (key) => {
    if (Number.isNaN(key)) return DASHES;
    return key < 1000 ? `${tenths(key)} kg` : `${grouped(Math.round(key / 10))} kg`;
  },
};

/** Share, 0 … 1: `42 %`. */
export const PERCENT: Format = {
  key: (value) => steps(value, 100),
  text: (key) => (Number.isNaN(key) ? DASHES : `${key} %`),
};

/** A direction, degrees from north: `020°`. */
export const BEARING: Format = {
  key: (value) => (Math.round(value) + 0) % 360,
  text: (key) => (Number.isNaN(key) ? DASHES : `${String(key).padStart(3, '0')}°`),
};

/** Remaining Δv, m/s: whole, `540 m/s`. */
export const DELTA_V: Format = {
  key: (value) => steps(value, 1),
  text: (key) => (Number.isNaN(key) ? DASHES : `${grouped(key)} m/s`),
};

export const COUNT: Format = {
  key: (value) => value,
  text: (key) => (Number.isNaN(key) ? DASHES : String(key)),
};

/** Rounded to whole steps of 1/perUnit; never −0, which would show as "−0.0". */
function steps(value: number, perUnit: number): number {
  return Math.round(value * perUnit) + 0;
}

/** Tenths as decimal text with a true minus. */
function tenths(key: number): string {
  const text = (Math.abs(key) / 10).toFixed(1);
  return key < 0 ? `−${text}` : text;
}

/** Whole number with thin groups of three: `12 345`. */
function grouped(value: number): string {
  const digits = String(Math.abs(Math.round(value)));
  const sign = value < 0 ? '−' : '';
  return sign + digits.replace(/\B(?=(\d{3})+$)/g, '\u202f');
}
