import type { Plugin } from 'vite';

export function leanThree(): Plugin;
