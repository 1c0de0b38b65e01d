export interface Python {
  command: string;
  env: Record<string, string | undefined>;
}
export function findPython(): Python | undefined;
export function servicePython(): Python;
export function redisServer(): string;
