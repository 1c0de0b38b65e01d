import type { Plugin } from 'vite';

export function withoutXr(): Plugin;
