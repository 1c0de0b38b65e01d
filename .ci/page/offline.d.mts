import type { Plugin } from 'vite';

export const OFFLINE_SCRIPT: string;
export function listForOffline(publicFolder: string): Plugin;
