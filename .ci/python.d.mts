export function servicePython(): { command: string; env: Record<string, string | undefined> };
export function redisServer(): string;
