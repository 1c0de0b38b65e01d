import type { LandingReadout } from './landing/landing';
import { DURATION } from './formats';

/** `PRED`, `CONF 0.4 s`, `PRED OFF ×100`, `STALE 2.1 s` (HUD, Provenance). A confirmed ground state also has its age. */
export function provenanceText(
  { provenance, status, timeScale }: Pick<LandingReadout, 'provenance' | 'status' | 'timeScale'>,
  ageKey: number,
): string {
  if (status === 'none') return '';
  const age = DURATION.text(ageKey);
  if (provenance === 'confirmed') return `CONF ${age}`;
  if (provenance === 'stale') return `STALE ${age}`;
  if (provenance === 'off') return `PRED OFF ×${scaleText(timeScale)}`;
  return status === 'flight' ? 'PRED' : `PRED ${age}`;
}

/** `LANDED withdrawn`; '' when nothing was withdrawn. */
export function withdrawnText(withdrawn: LandingReadout['withdrawn']): string {
  return withdrawn === '' ? '' : `${withdrawn.toUpperCase()} withdrawn`;
}

/** At most two decimals, without trailing zeros: 100, 2.5, 0.13. */
function scaleText(timeScale: number): string {
  return String(Math.round(timeScale * 100) / 100);
}
