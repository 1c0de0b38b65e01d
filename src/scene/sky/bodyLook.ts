import type { SunPlace } from '../localFrame';

/** The look of a body's ground and sky. Colours are linear RGB, 0 … 1. */
export interface BodyLook {
  /** Dust between stones, its patches some hundred metres wide, and the stones. */
  readonly dust: readonly [number, number, number];
  readonly cover: readonly [number, number, number];
  readonly stone: readonly [number, number, number];
  /** 1: ground that reflects equally at all angles, like dark regolith; 0: Lambert. */
  readonly regolith: number;
  readonly sun: SunPlace;
  readonly sunColour: readonly [number, number, number];
  readonly sunStrength: number;
  /** Light from the sky, and the sky's colours; null: no air, black sky, stars. */
  readonly air: Air | null;
  /** Light in shadows where there is no air: from the sunlit ground around. */
  readonly fill: readonly [number, number, number];
  /** Another body in the sky: direction in the local frame, angular radius in degrees, colours. */
  readonly neighbour: Neighbour | null;
  /** Relative number of stones per square metre near the ship. */
  readonly stoniness: number;
}

export interface Air {
  readonly zenith: readonly [number, number, number];
  readonly horizon: readonly [number, number, number];
  /** Around the sun. */
  readonly glow: readonly [number, number, number];
  /** Metres over which the far ground takes 63 % of the horizon's colour. */
  readonly clearness: number;
  /** Metres over which the air thins to 37 %. */
  readonly scaleHeight: number;
  /** Share of the sky behind thin clouds, 0 … 1. */
  readonly clouds: number;
  /** 1/s: how fast it stops dust. */
  readonly drag: number;
}

export interface Neighbour {
  readonly azimuth: number;
  readonly elevation: number;
  readonly radius: number;
  readonly day: readonly [number, number, number];
  readonly spots: readonly [number, number, number];
}

const MOON: BodyLook = {
  dust: [0.2, 0.193, 0.183],
  cover: [0.155, 0.15, 0.143],
  stone: [0.3, 0.292, 0.28],
  regolith: 0.7,
  sun: { elevation: 13, azimuth: 58 },
  sunColour: [1, 0.975, 0.93],
  sunStrength: 4.6,
  air: null,
  fill: [0.085, 0.087, 0.095],
  neighbour: {
    azimuth: 283,
    elevation: 9.5,
    radius: 1.7,
    day: [0.1, 0.22, 0.55],
    spots: [0.8, 0.85, 0.9],
  },
  stoniness: 1,
};

const PHOBOS: BodyLook = {
  dust: [0.105, 0.096, 0.09],
  cover: [0.11, 0.107, 0.105],
  stone: [0.17, 0.158, 0.148],
  regolith: 0.8,
  sun: { elevation: 19, azimuth: 40 },
  sunColour: [1, 0.96, 0.9],
  sunStrength: 5,
  air: null,
  fill: [0.085, 0.066, 0.055],
  neighbour: {
    azimuth: 291,
    elevation: 11,
    radius: 20,
    day: [0.55, 0.24, 0.11],
    spots: [0.3, 0.13, 0.075],
  },
  stoniness: 1.6,
};

const MARS: BodyLook = {
  dust: [0.4, 0.17, 0.08],
  cover: [0.23, 0.11, 0.066],
  stone: [0.25, 0.115, 0.066],
  regolith: 0.25,
  sun: { elevation: 17, azimuth: 62 },
  sunColour: [1, 0.9, 0.76],
  sunStrength: 3.3,
  air: {
    zenith: [0.26, 0.15, 0.085],
    horizon: [0.62, 0.4, 0.235],
    glow: [0.7, 0.72, 0.8],
    clearness: 14_000,
    scaleHeight: 11_000,
    clouds: 0.12,
    drag: 0.5,
  },
  fill: [0.11, 0.065, 0.04],
  neighbour: null,
  stoniness: 2.4,
};

const EARTH: BodyLook = {
  dust: [0.185, 0.145, 0.075],
  cover: [0.075, 0.095, 0.032],
  stone: [0.2, 0.18, 0.14],
  regolith: 0,
  sun: { elevation: 21, azimuth: 65 },
  sunColour: [1, 0.93, 0.8],
  sunStrength: 3.4,
  air: {
    zenith: [0.05, 0.17, 0.47],
    horizon: [0.42, 0.58, 0.76],
    glow: [1, 0.82, 0.55],
    clearness: 26_000,
    scaleHeight: 8500,
    clouds: 0.75,
    drag: 1.6,
  },
  fill: [0.075, 0.1, 0.14],
  neighbour: null,
  stoniness: 0.5,
};

const LOOKS: Readonly<Record<string, BodyLook>> = { Luna: MOON, Earth: EARTH, Mars: MARS, Phobos: PHOBOS };

/** The look of a body by its name; unknown bodies look like the Moon. */
export function lookOf(bodyName: string): BodyLook {
  return Object.hasOwn(LOOKS, bodyName) ? LOOKS[bodyName]! : MOON;
}
