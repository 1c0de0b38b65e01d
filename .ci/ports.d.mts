export function freePort(): Promise<number>;
export function requireFree(port: number, whose: { what: string; option: string }): Promise<void>;
