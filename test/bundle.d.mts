import type { Plugin } from 'vite';

export function bundleRun(groups: string[][]): void;
export function bundledTests(): Plugin;
