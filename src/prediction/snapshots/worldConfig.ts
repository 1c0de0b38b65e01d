import {
  ok,
  type Body,
  type BodyMotion,
  type Result,
  DEFAULT_SETTINGS,
  loadBody,
  loadSettings,
  loadShipClass,
  err,
  type Settings,
  type ShipClass,
  type TerrainHeight,
  type World,
} from '../../dynamics';

/** What a server tells once, or what stands in for it: enough to make a world of. */
export interface WorldConfig {
  readonly settings: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  readonly bodies: readonly (Body & BodyMotion)[];
  readonly terrain: string;
}

/** The world that was told, with its constants, or the reason, naming the field, why it cannot be simulated. */
export function loadWorld(
  told: WorldConfig,
  terrains: Readonly<Record<string, TerrainHeight>>,
): Result<World> {
  const settings = loadSettings(plainSettings(told.settings));
  if (!settings.ok) return err(`settings.${settings.reason}`);
  if (!Object.hasOwn(terrains, told.terrain)) return err(`terrain: no terrain named ${told.terrain}`);
  const shipClasses = loadEach('shipClasses', told.shipClasses, loadShipClass);
  if (!shipClasses.ok) return shipClasses;
  const bodies = loadEach('bodies', told.bodies, loadBody);
  if (!bodies.ok) return bodies;
  return ok({
    settings: settings.value,
    shipClasses: shipClasses.value,
    bodies: bodies.value,
    terrainHeight: terrains[told.terrain]!,
  });
}

/** The settings alone, of a record that may be a loaded one with its constants. */
function plainSettings(given: Partial<Settings>): Partial<Settings> {
  return Object.fromEntries(Object.entries(given).filter(([name]) => Object.hasOwn(DEFAULT_SETTINGS, name)));
}

/** Whether two tellings make the same world: places and motions of bodies aside, which frames tell. */
export function sameWorld(a: WorldConfig, b: WorldConfig): boolean {
  const constants = ({ settings, shipClasses, bodies, terrain }: WorldConfig) =>
    JSON.stringify([
      settings,
      shipClasses,
      bodies.map(({ name, mass, radius }) => [name, mass, radius]),
      terrain,
    ]);
  return constants(a) === constants(b);
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
