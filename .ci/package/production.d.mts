import type { Plugin } from 'vite';

type Functions = Readonly<Record<string, readonly string[]>>;

export const CALL_CHECKS: Functions;
export function withoutChecks(src: string, functions: Functions): Plugin;
