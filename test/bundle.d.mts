import type { Plugin } from 'vite';

export function bundledTests(): Plugin;
export function mutation(): Plugin[];
