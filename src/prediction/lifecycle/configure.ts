import { err, ok, type Result } from '../../dynamics';
import type { Defaults } from '../options';
import type { Session } from '../session';
import { loadGiven } from '../snapshots/worldConfig';
import { changeWorld } from './changeWorld';

/** The members of the running world that a caller changes. A reason that names the field where one cannot be; nothing changes then. */
export function configure(session: Session, changes: Partial<Defaults> | null): Result<null> {
  if (typeof changes !== 'object' || changes === null)
    return err(
      `configure: expected an object with settings, shipClasses, bodies, terrain, got ${typeof changes}`,
    );
  const { config, terrains } = session;
  const settings = { ...config.settings, ...changes.settings };
  const next = { ...config, ...changes, settings };
  const world = loadGiven(next, terrains);
  if (!world.ok) return err(`configure: ${world.reason}`);
  changeWorld(session, world.value, next);
  return ok(null);
}
