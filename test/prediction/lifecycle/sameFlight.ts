import type { EventNotice, LeanPredictor, PredictorEntry, WorldView } from '../../../src/prediction';
import type { ClientMessage } from '../../../src/wire';

/** What a predictor shows, sends and announces with one display frame of a flight. */
export interface Moment {
  readonly view: WorldView;
  readonly sent: readonly ClientMessage[];
  /** Since the moment before. */
  readonly notices: readonly EventNotice[];
}

/** Each display frame of the flight; the predictor reuses its view. */
export function* momentsOf(
  predictor: LeanPredictor,
  entries: readonly PredictorEntry[],
): Generator<Moment, void> {
  let notices: EventNotice[] = [];
  predictor.onEvent((notice) => notices.push({ ...notice }));
  for (const entry of entries) {
    if (entry.kind === 'received') predictor.receive(entry.message, entry.at);
    if (entry.kind !== 'advanced') continue;
    predictor.advance(entry.controls, entry.at);
    yield { view: predictor.view(entry.at), sent: predictor.takeOutgoing(), notices };
    notices = [];
  }
}

type Fields = Readonly<Record<string, unknown>>;

/** Where two values differ first, bit for bit, and how; '' if nowhere. Fields in `hidden` are not compared, at any depth. */
function difference(a: unknown, b: unknown, hidden: ReadonlySet<string>, path = ''): string {
  if (Object.is(a, b)) return '';
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null)
    return `${path}: ${String(a)} and ${String(b)}`;
  for (const key in a) {
    if (hidden.has(key)) continue;
    const found = difference((a as Fields)[key], (b as Fields)[key], hidden, `${path}.${key}`);
    if (found !== '') return found;
  }
  for (const key in b) if (!(key in a) && !hidden.has(key)) return `${path}.${key}: missing`;
  return '';
}

/**
 * The first difference between two flights, '' if they are the same, bit for bit. Of `hidden` neither fields of that name nor messages
 * of that kind are compared.
 */
export function differenceOfFlights(
  flight: Iterator<Moment, void>,
  other: Iterator<Moment, void>,
  hidden: readonly string[] = [],
): string {
  const names = new Set(hidden);
  const seen = ({ sent, ...rest }: Moment) => ({
    ...rest,
    sent: sent.filter(({ kind }) => !names.has(kind)),
  });
  for (let n = 0; ; n++) {
    const [a, b] = [flight.next(), other.next()];
    if (a.done === true || b.done === true) return a.done === b.done ? '' : `ends at display frame ${n}`;
    const found = difference(seen(a.value), seen(b.value), names);
    if (found !== '') return `display frame ${n}${found}`;
  }
}
