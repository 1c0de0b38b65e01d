import {
  type Body,
  type BodyMotion,
  err,
  loadWorld,
  type Result,
  type Settings,
  type ShipClass,
  type TerrainHeight,
  type World,
} from '../../dynamics';

/** The world config that a server sends once, or the defaults in its place: enough to build a world. */
export interface WorldConfig {
  readonly settings: Partial<Settings>;
  readonly shipClasses: readonly ShipClass[];
  readonly bodies: readonly (Body & BodyMotion)[];
  /** A name in `terrains`. */
  readonly terrain: string;
}

/** The configured world with its constants, or a reason, naming the field, why it cannot be simulated. */
export function loadConfig(
  config: WorldConfig,
  terrains: Readonly<Record<string, TerrainHeight>>,
): Result<World> {
  if (!Object.hasOwn(terrains, config.terrain)) return err(`terrain: no terrain named ${config.terrain}`);
  return loadWorld({ ...config, terrainHeight: terrains[config.terrain]! });
}

/** Whether two configs make the same world, apart from the bodies' positions and motions, which frames carry. */
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
