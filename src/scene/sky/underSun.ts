import type { Air, BodyLook, Neighbour } from './bodyLook';

/** A body's look under a sun of a given elevation. By night `sun`, `sunColour` and `sunStrength` are those of the brightest light left. */
export interface SceneLook extends BodyLook {
  /** Degrees in the local frame: from its x axis towards z, and above the horizon. By day the sun is over the x axis. */
  readonly trueSun: { readonly azimuth: number; readonly elevation: number };
  readonly isNight: boolean;
}

/** Elevation of the sun by night, degrees: too low to light the sky of a body with air. */
export const NIGHT_ELEVATION = -14;
/** Lowest sun, degrees: at the horizon shadows would be endless. */
const LOWEST_SUN = 2;
/** Of the day's sun. The real ratios are 1 : 10,000 and less; the exposure is that of an eye adapted to the dark. */
const NIGHT_STRENGTH = 0.22;
const NIGHT_FILL = 0.4;
const NIGHT_AIR = 0.018;
const MOONLIGHT = { azimuth: 0, elevation: 34, colour: [0.7, 0.8, 1] as const };
/** How far a neighbour's own colour tints its light, 0 … 1. */
const TINT = 0.6;

/** @param elevation of the sun in degrees, or null for the body's own; at or below 0 it is night */
export function underSun(look: BodyLook, elevation: number | null): SceneLook {
  if (elevation === null) return dayLook(look, look.sun.elevation);
  return elevation > 0 ? dayLook(look, Math.max(elevation, LOWEST_SUN)) : nightLook(look, elevation);
}

function dayLook(look: BodyLook, elevation: number): SceneLook {
  return {
    ...look,
    sun: { ...look.sun, elevation },
    trueSun: { azimuth: 0, elevation },
    isNight: false,
  };
}

/** Lit by the neighbour in the sky, which the sun still reaches, or by a moon. The frame's x axis turns to that light. */
function nightLook(look: BodyLook, elevation: number): SceneLook {
  const { neighbour, sun } = look;
  const from = neighbour ?? MOONLIGHT;
  return {
    ...look,
    // In the frame azimuths run from x to z, on the ground from east to north: the other way round.
    sun: { azimuth: sun.azimuth - from.azimuth, elevation: from.elevation },
    trueSun: { azimuth: -from.azimuth, elevation },
    sunColour: neighbour === null ? MOONLIGHT.colour : shineOf(neighbour),
    sunStrength: look.sunStrength * NIGHT_STRENGTH,
    fill: scaled(look.fill, NIGHT_FILL),
    air: look.air === null ? null : nightAir(look.air),
    neighbour: neighbour === null ? null : { ...neighbour, azimuth: 0 },
    isNight: true,
  };
}

type Colour = readonly [number, number, number];

function shineOf({ day, spots }: Neighbour): Colour {
  const mixed = day.map((value, k) => (value + spots[k]!) / 2);
  const brightest = Math.max(...mixed);
  const [r, g, b] = mixed.map((value) => 1 - TINT + (TINT * value) / brightest);
  return [r!, g!, b!];
}

function nightAir(air: Air): Air {
  return {
    ...air,
    zenith: scaled(air.zenith, NIGHT_AIR),
    horizon: scaled(air.horizon, NIGHT_AIR),
    glow: scaled(air.glow, NIGHT_AIR),
  };
}

function scaled([r, g, b]: Colour, by: number): Colour {
  return [r * by, g * by, b * by];
}
