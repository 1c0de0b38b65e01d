import { ok, type Result, err } from '../../../dynamics';
import { readRun, type RunInput, writeRun } from '../../../scenarios';

/** Prefix of a mission's name: the key of its best run. */
export const BEST_RUN_KEY = 'touchdown.best.';

const MAX_TEXT = 200_000;
/** Length of a link that mail and chat do not break. */
export const MAX_LINK_LENGTH = 8000;

/** The bytes of a run as base64url, for a link or the store. */
export function textOf(bytes: Uint8Array): string {
  let binary = '';
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** The bytes of a string; null if it is not base64url. */
export function bytesOf(text: string): Uint8Array | null {
  if (!/^[\w-]*$/.test(text) || text.length > MAX_TEXT) return null;
  try {
    return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
  } catch {
    return null;
  }
}

/** @param substeps of a tick */
export function writeFlight(inputs: readonly RunInput[], substeps: number): string {
  return textOf(writeRun(inputs, substeps));
}

/** The inputs of a flight in text form, or why they cannot be read. */
export function readFlight(text: string, substeps: number): Result<readonly RunInput[]> {
  const bytes = bytesOf(text);
  if (bytes === null) return err('not base64url');
  const read = readRun(bytes, substeps);
  return read.ok ? ok(read.value) : read;
}
