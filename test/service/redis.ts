import { spawnSync } from 'node:child_process';

/** Whether a redis-server can be started here (`apt-get install redis-server`). */
export function hasRedis(): boolean {
  return spawnSync('redis-server', ['--version']).status === 0;
}
