import type { Plugin } from 'vite';
export function bundledTests(): Plugin;
