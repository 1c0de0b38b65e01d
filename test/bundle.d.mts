import type { Plugin } from 'vite';

export function bundleRun(tests: string[]): void;
export function bundledTests(): Plugin;
export function mutation(): Plugin[];
