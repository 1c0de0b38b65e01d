/** Tells operators why a key of Redis cannot be used: each reason once, until the key can be used or the reason changes. */
export interface Faults {
  /** @param error of a command on `key`, whose type is `type`; or the reason itself */
  readonly report: (key: string, type: string, error: unknown) => void;
  readonly clear: (key: string) => void;
}

/** @param log takes one line per fault */
export function createFaults(log: (line: string) => void): Faults {
  const reported = new Map<string, string>();
  return {
    report(key, type, error) {
      const line = isWrongType(error) ? `${key}: expected a ${type}` : lineOf(error);
      if (reported.get(key) === line) return;
      reported.set(key, line);
      log(line);
    },
    clear: (key) => reported.delete(key),
  };
}

/** Whether Redis refused a command because its key holds another type. */
export function isWrongType(error: unknown): boolean {
  return error instanceof Error && error.message.startsWith('WRONGTYPE');
}

function lineOf(error: unknown): string {
  return error instanceof Error ? `redis: ${error.message}` : String(error);
}
