import type { Plugin } from 'vite';

export function production(src: string): Plugin;
