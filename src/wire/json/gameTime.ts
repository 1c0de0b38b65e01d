import { GAME_SECONDS } from '../limits';
import { describe, type Fields, numberIn, type Reading, refuse, valueIn } from '../fields/reading';

/** ISO 8601 as in `game:time`: a date, a time, a zone or none (then UTC). */
const ISO = /^(\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d):(\d\d(?:\.\d{1,9})?)(?:Z|([+-])(\d\d):?(\d\d))?$/;

/** Game time `name`, s since 1970-01-01T00:00:00Z: a number, or an ISO 8601 string. */
export function gameTimeIn(r: Reading, from: Fields, name: string): number {
  const value = valueIn(r, from, name);
  if (typeof value !== 'string' || !value.includes('-', 1)) return numberIn(r, from, name, GAME_SECONDS);
  const parts = ISO.exec(value);
  if (parts === null) {
    refuse(r, name, `expected seconds or ISO 8601, got ${describe(value)}`);
    return NaN;
  }
  const [year, month, day, hour, minute, second] = parts.slice(1, 7).map(Number) as Six;
  const zone = (Number(parts[8] ?? 0) * 60 + Number(parts[9] ?? 0)) * (parts[7] === '-' ? -60 : 60);
  return daysSince1970(year, month, day) * 86400 + hour * 3600 + minute * 60 + second - zone;
}

type Six = [number, number, number, number, number, number];

/** Days since 1970-01-01 in the proleptic Gregorian calendar. Years begin in March here, so that the leap day comes last. */
function daysSince1970(year: number, month: number, day: number): number {
  const y = month <= 2 ? year - 1 : year;
  const era = Math.floor(y / 400);
  const yearOfEra = y - era * 400;
  const dayOfYear = Math.floor((153 * (month + (month > 2 ? -3 : 9)) + 2) / 5) + day - 1;
  const dayOfEra = yearOfEra * 365 + Math.floor(yearOfEra / 4) - Math.floor(yearOfEra / 100) + dayOfYear;
  return era * 146097 + dayOfEra - 719468;
}
