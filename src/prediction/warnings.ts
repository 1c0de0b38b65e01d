/**
 * What a caller or a server got wrong and nothing has to stop for (PREDICTION, Messages that are valid and still wrong): each code
 * is told once per predictor, with the value that was found and what to do about it.
 */
export type Warn = (code: string, message: string, details: Readonly<Record<string, unknown>>) => void;

/** Makes a `warn` that passes on each code once. A listener that throws is ignored; without one nothing happens. */
export function createWarn(listener: Warn | undefined): Warn {
  const told = new Set<string>();
  return (code, message, details) => {
    if (listener === undefined || told.has(code)) return;
    told.add(code);
    try {
      listener(code, message, details);
    } catch {
      // The listener's own fault: nobody else is to suffer from it.
    }
  };
}
