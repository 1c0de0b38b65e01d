// The folder that holds Redis's files while the live stack runs.
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

/** Written by Redis, and removed by it when it ends. */
const OWNER = 'redis.pid';

/**
 * A temporary folder, removed on release; or `kept`, which stays.
 * @throws Error if a Redis runs on `kept`: two on the same files would corrupt them
 */
export function openDataFolder(kept) {
  const path = kept === undefined ? mkdtempSync(join(tmpdir(), 'touchdown-live-')) : resolve(kept);
  mkdirSync(path, { recursive: true });
  const pidFile = join(path, OWNER);
  const owner = ownerOf(pidFile);
  if (owner !== null && isAlive(owner))
    throw new Error(
      `${path} is in use by the Redis of process ${owner} (${OWNER}): end it, or choose another folder with --data`,
    );
  const close = () => {
    if (kept === undefined) rmSync(path, { recursive: true, force: true });
  };
  return { path, pidFile, isKept: kept !== undefined, close };
}

function ownerOf(file) {
  try {
    return Number(readFileSync(file, 'utf8'));
  } catch {
    return null;
  }
}

function isAlive(pid) {
  if (!Number.isInteger(pid) || pid <= 0) return false;
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return error.code === 'EPERM';
  }
}
