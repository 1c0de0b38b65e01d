export interface Process {
  readonly name: string;
  readonly start: () => Promise<void>;
  /** Ends it with a signal; resolves when it is gone. */
  readonly end: (signal: string) => Promise<void>;
  readonly pid: () => number;
  /** Its latest output. */
  readonly said: () => string;
  readonly whenItDies: (act: (how: string | number | null) => void) => void;
}
export interface Stack {
  readonly redis: Process;
  readonly service: Process;
  readonly gateway: Process;
  readonly redisUrl: string;
  readonly gatewayPort: number;
  /** Where Redis keeps its files. */
  readonly folder: { readonly path: string; readonly isKept: boolean };
  readonly stop: () => Promise<void>;
}
export function createProcess(program: {
  name: string;
  command: string;
  args: readonly string[];
  env: Record<string, string | undefined>;
  upWhen: RegExp;
}): Process;
export function createStack(options: {
  gatewayEnv: Record<string, string>;
  appendfsync: 'always' | 'everysec' | 'no';
  ports?: { redis?: number; gateway?: number };
  data?: string;
  serviceArgs?: readonly string[];
}): Promise<Stack>;
