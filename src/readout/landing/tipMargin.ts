import type { Surface } from '../surface';

/** How far a ship in contact is from toppling (HUD, tip margin). */
export interface TipMargin {
  /** While in contact. */
  shown: boolean;
  /** Degrees left before the point of no return; negative past it. */
  degrees: number;
  /**
   * 'tips': simulated ahead under the present controls, the ship tips. 'holds': it does not within half a minute. 'working': no answer
   * yet; a lean readout stays there.
   */
  outlook: 'steady' | 'working' | 'tips' | 'holds';
  /** Game s until TIPPED; NaN unless outlook is 'tips'. */
  timeToTipped: number;
}

/** rad/s of growing lean from which a ship still within its feet is not steady. */
const WORTH_A_LOOK = 0.02;

export function createTipMargin(): TipMargin {
  return { shown: false, degrees: NaN, outlook: 'steady', timeToTipped: NaN };
}

/** From the present lean alone, before anything is simulated ahead. */
export function measureTipMargin(out: TipMargin, surface: Surface): void {
  const left = surface.noReturn - surface.lean;
  out.shown = true;
  out.degrees = (left * 180) / Math.PI;
  out.outlook = left > 0 && surface.tiltRate < WORTH_A_LOOK ? 'steady' : 'working';
  out.timeToTipped = NaN;
}
