/// <reference types="vitest/config" />
import type { UserConfig } from 'vite';
export const tests: UserConfig;
export const longTests: UserConfig;
