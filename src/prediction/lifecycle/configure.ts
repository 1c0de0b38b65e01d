import { err, ok, type Result } from '../../dynamics';
import { checkDefaults, faultOfDefaults } from '../checks/options';
import { describe } from '../checks/describe';
import type { Defaults } from '../options';
import type { Session } from '../session';
import { loadUntrusted } from './worldConfig';
import { changeWorld } from './changeWorld';

/** Changes members of the running world. Returns an error that names the invalid field; then nothing changes. */
export function configure(session: Session, changes: Partial<Defaults> | null): Result<null> {
  const { config, warn } = session;
  if (typeof changes !== 'object' || changes === null)
    return refuse(
      session,
      `expected an object with settings, shipClasses, bodies, terrain, got ${describe(changes)}`,
    );
  const fault = faultOfDefaults(changes);
  if (fault !== null) return refuse(session, fault);
  checkDefaults(warn, 'configure', changes);
  const settings = { ...config.settings, ...changes.settings };
  const next = { ...config, ...changes, settings };
  const world = loadUntrusted(next, session);
  if (!world.ok) return refuse(session, world.reason);
  changeWorld(session, world.value, next);
  return ok(null);
}

function refuse({ warn }: Session, reason: string): Result<null> {
  warn('configure-refused', `configure: ${reason}. Nothing was changed.`, { reason });
  return err(`configure: ${reason}`);
}
