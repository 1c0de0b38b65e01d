/**
 * Reports mistakes of the caller or the server; nothing stops (PREDICTION, Invalid messages). Each code is reported once per predictor and field,
 * with the value found and what to do about it.
 */
export type Warn = (code: string, message: string, details: Readonly<Record<string, unknown>>) => void;

/** Most warnings of one predictor, so that invented names cannot fill the memory. */
const MAX_REPORTED = 200;

/** Creates a `warn` that reports each code once, or once per `details.field`. A listener that throws is ignored; without one nothing happens. */
export function createWarn(listener: Warn | undefined): Warn {
  const reported = new Set<string>();
  return (code, message, details) => {
    if (listener === undefined || reported.size >= MAX_REPORTED) return;
    const { field } = details;
    const key = typeof field === 'string' ? `${code} ${field}` : code;
    if (reported.has(key)) return;
    reported.add(key);
    try {
      listener(code, message, details);
    } catch {
      // A fault of the listener must not affect the predictor.
    }
  };
}
