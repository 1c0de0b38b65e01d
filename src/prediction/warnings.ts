/**
 * What a caller or a server got wrong and nothing has to stop for (PREDICTION, Invalid messages): each code
 * is told once per predictor and field, with the value that was found and what to do about it.
 */
export type Warn = (code: string, message: string, details: Readonly<Record<string, unknown>>) => void;

/** Warnings of one predictor: a caller that makes up names does not fill the memory. */
const MAX_TOLD = 200;

/** Makes a `warn` that passes on each code once, and once per `details.field` where there is one. A listener that throws is ignored; without one nothing happens. */
export function createWarn(listener: Warn | undefined): Warn {
  const told = new Set<string>();
  return (code, message, details) => {
    if (listener === undefined || told.size >= MAX_TOLD) return;
    const { field } = details;
    const key = typeof field === 'string' ? `${code} ${field}` : code;
    if (told.has(key)) return;
    told.add(key);
    try {
      listener(code, message, details);
    } catch {
      // The listener's own fault: nobody else is to suffer from it.
    }
  };
}
