import { err, ok, type Result } from '../result';
import { type Body, loadBody } from './body';
import { DEFAULT_SETTINGS, loadSettings, type Settings } from './settings';
import { loadShipClass, type ShipClass } from './shipClass';
import type { TerrainHeight, World } from './world';

/** The plain data of a world. */
export interface WorldData {
  /** Settings that differ from the defaults. */
  readonly settings: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  readonly bodies: readonly Body[];
  readonly terrainHeight: TerrainHeight;
}

/** The world with derived constants, or an error that names the first invalid field: `settings.…`, `shipClasses[0]: …`, `bodies[0]: …`. */
export function loadWorld({ settings, shipClasses, bodies, terrainHeight }: WorldData): Result<World> {
  const loadedSettings = loadSettings(withoutConstants(settings));
  if (!loadedSettings.ok) return err(`settings.${loadedSettings.reason}`);
  const loadedClasses = loadEach('shipClasses', shipClasses, loadShipClass);
  if (!loadedClasses.ok) return loadedClasses;
  const loadedBodies = loadEach('bodies', bodies, loadBody);
  if (!loadedBodies.ok) return loadedBodies;
  return ok({
    settings: loadedSettings.value,
    shipClasses: loadedClasses.value,
    bodies: loadedBodies.value,
    terrainHeight,
  });
}

/** The settings alone, from a record that may be loaded and have derived constants. */
function withoutConstants(given: Partial<Settings>): Partial<Settings> {
  return Object.fromEntries(Object.entries(given).filter(([name]) => Object.hasOwn(DEFAULT_SETTINGS, name)));
}

function loadEach<Given, Loaded>(
  field: string,
  given: readonly Given[],
  load: (one: Given) => Result<Loaded>,
): Result<readonly Loaded[]> {
  if (given.length === 0) return err(`${field}: expected at least one`);
  const loaded: Loaded[] = [];
  for (const [i, one] of given.entries()) {
    const checked = load(one);
    if (!checked.ok) return err(`${field}[${i}]: ${checked.reason}`);
    loaded.push(checked.value);
  }
  return ok(loaded);
}
