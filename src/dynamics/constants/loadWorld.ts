import { err, ok, type Result } from '../result';
import { type Body, type LoadedBody, loadBody } from './body';
import { DEFAULT_SETTINGS, deriveSettings, faultOfSettings, type Settings } from './settings';
import { deriveShipClass, faultOfShipClass, type ShipClass } from './shipClass';
import { TERRAIN_NORMALS } from '../contact/terrainNormals';
import type { TerrainHeight, TerrainNormals, World } from './world';

/** The plain data of a world. */
export interface WorldData {
  /** Settings that differ from the defaults. */
  readonly settings: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  readonly bodies: readonly Body[];
  readonly terrainHeight: TerrainHeight;
}

/** The world with derived constants, or an error that names the first invalid field: `settings.…`, `shipClasses[0]: …`, `bodies[0]: …`. */
export function loadWorld(given: WorldData): Result<World> {
  const reason = faultOfConstants(given);
  return reason === null ? deriveWorld(given, TERRAIN_NORMALS) : err(reason);
}

/** The settings and classes of a world. */
export type WorldConstants = Pick<WorldData, 'settings' | 'shipClasses'>;

/** The first invalid field of the settings and classes, or null. */
export function faultOfConstants({ settings, shipClasses }: WorldConstants): string | null {
  const reason = faultOfSettings(withoutConstants(settings));
  if (reason !== null) return `settings.${reason}`;
  if (shipClasses.length === 0) return 'shipClasses: expected at least one';
  for (const [i, shipClass] of shipClasses.entries()) {
    const fault = faultOfShipClass(shipClass);
    if (fault !== null) return `shipClasses[${i}]: ${fault}`;
  }
  return null;
}

/** The same as loadWorld for settings and classes that are known to be valid; only the bodies are checked. `terrainNormals` may be null for radial normals. */
export function deriveWorld(
  { settings, shipClasses, bodies, terrainHeight }: WorldData,
  terrainNormals: TerrainNormals | null,
): Result<World> {
  if (bodies.length === 0) return err('bodies: expected at least one');
  const loaded: LoadedBody[] = [];
  for (const [i, body] of bodies.entries()) {
    const checked = loadBody(body);
    if (!checked.ok) return err(`bodies[${i}]: ${checked.reason}`);
    loaded.push(checked.value);
  }
  return ok({
    settings: deriveSettings(withoutConstants(settings)),
    shipClasses: shipClasses.map(deriveShipClass),
    bodies: loaded,
    terrainHeight,
    terrainNormals,
  });
}

/** The settings alone, from a record that may be loaded and have derived constants. */
function withoutConstants(given: Partial<Settings>): Partial<Settings> {
  return Object.fromEntries(Object.entries(given).filter(([name]) => Object.hasOwn(DEFAULT_SETTINGS, name)));
}
