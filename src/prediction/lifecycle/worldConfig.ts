import {
  type Body,
  type BodyMotion,
  deriveWorld,
  err,
  type faultOfConstants,
  type Result,
  type Settings,
  type ShipClass,
  type TerrainHeight,
  type TerrainNormals,
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

/** The inputs to loading a world: the terrains that it may name, and the check of its settings and classes if the page loads it. */
export interface WorldLoader {
  readonly terrains: Readonly<Record<string, TerrainHeight>>;
  readonly features: {
    readonly faultOfConstants?: typeof faultOfConstants;
    readonly terrainNormals?: TerrainNormals;
  };
}

/** The configured world with its constants, or an error that names the invalid field. */
export function loadConfig(config: WorldConfig, { terrains, features }: WorldLoader): Result<World> {
  if (!Object.hasOwn(terrains, config.terrain)) return err(`terrain: no terrain named ${config.terrain}`);
  const { terrainNormals = null } = features;
  if (config.settings.surfaceNormal === 'terrain' && terrainNormals === null)
    return err('settings.surfaceNormal: expected radial without the feature terrainNormals');
  const reason = features.faultOfConstants?.(config) ?? null;
  if (reason !== null) return err(reason);
  return deriveWorld({ ...config, terrainHeight: terrains[config.terrain]! }, terrainNormals);
}

/** The same for a config from a JavaScript caller or a server: missing members do not throw. */
export function loadUntrusted(config: WorldConfig, loader: WorldLoader): Result<World> {
  try {
    return loadConfig(config, loader);
  } catch (error) {
    return err(`world: ${String(error)}`);
  }
}

interface Named {
  readonly bodies: readonly { readonly name: string }[];
}

/** Whether two worlds have the same bodies, in the same order: then rows of one are valid in the other, except for the class. */
export function sameBodies(a: Named, b: Named): boolean {
  return a.bodies.length === b.bodies.length && a.bodies.every(({ name }, i) => name === b.bodies[i]!.name);
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
