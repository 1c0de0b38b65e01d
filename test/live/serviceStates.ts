import { createClient } from 'redis';
import {
  beginTick,
  BODY_STRIDE,
  loadBody,
  loadSettings,
  loadShipClass,
  POSITION,
  SHIP_CLASSES,
  SHIP_STRIDE,
  type ShipRecord,
  stepWorld,
  TERRAINS,
  timingOfTick,
  type Vec3,
  type World,
  writeBodyMotion,
  writeShip,
  TERRAIN_NORMALS,
} from '../../src/dynamics';
import { decodeFrameJson, type PartialFrame } from '../../src/wire';
import { valueOf } from '../authority/moon';

/** An instant of game time: a tick boundary and game seconds since. */
export interface Instant {
  readonly tick: number;
  readonly sinceTick: number;
}

/** The service's states, read from its frames in Redis while it runs. */
export interface ServiceStates {
  /**
   * Position of a coasting ship relative to its body's centre, ICRF axes, m: the dynamics continued from the service's state
   * at that tick. null if the service's frame of that tick was not seen or the ship was not in it.
   */
  readonly positionAt: (shipId: string, instant: Instant) => Vec3 | null;
  readonly stop: () => void;
}

/** Wall ms for which a read waits. */
const BLOCK = 500;

export async function readServiceStates(redisUrl: string): Promise<ServiceStates> {
  const redis = createClient({ url: redisUrl });
  redis.on('error', () => undefined);
  await redis.connect();
  const frames = new Map<number, PartialFrame>();
  let stopped = false;
  const isStopped = () => stopped;

  async function read(): Promise<void> {
    let id = '$';
    while (!isStopped()) {
      const streams = await redis.xRead({ key: 'touchdown:frames', id }, { BLOCK });
      const entries = (streams ?? []) as unknown as FrameEntries;
      for (const entry of entries[0]?.messages ?? []) {
        id = entry.id;
        const frame = valueOf(decodeFrameJson(JSON.parse(entry.message['frame']!)));
        frames.set(frame.tick, frame);
      }
    }
  }
  // `stop` closes the connection under a waiting read.
  read().catch(() => undefined);

  return {
    positionAt(shipId, { tick, sinceTick }) {
      const frame = frames.get(tick);
      return frame === undefined ? null : continueFrom(frame, shipId, sinceTick);
    },
    stop() {
      stopped = true;
      redis.destroy();
    },
  };
}

type FrameEntries = { messages: { id: string; message: Record<string, string> }[] }[];

/** The state `seconds` of game time after a frame, linear between two substeps, as in the view. */
function continueFrom(frame: PartialFrame, shipId: string, seconds: number): Vec3 | null {
  const ship = frame.ships.find((candidate) => candidate.shipId === shipId);
  if (ship === undefined) return null;
  const world = worldOf(frame);
  const row = new Float64Array(SHIP_STRIDE);
  const refused = writeShip(row, 0, ship as unknown as ShipRecord, world);
  if (refused !== null) throw new Error(refused);
  const bodies = new Float64Array(world.bodies.length * BODY_STRIDE);
  for (const [i, body] of (frame.bodies ?? []).entries()) writeBodyMotion(bodies, i * BODY_STRIDE, body);
  const tickSeconds = frame.timeScale! / frame.tickRate!;
  const { dt } = timingOfTick(tickSeconds, world.settings.contactLongestSubstep);
  beginTick(row, bodies, world);
  const steps = seconds / dt;
  const events = new Uint8Array(1);
  let before = positionOf(row);
  for (let s = 0; s < steps; s++) {
    before = positionOf(row);
    stepWorld(row, bodies, events, world, dt);
  }
  const after = positionOf(row);
  const share = steps - Math.floor(steps);
  if (share === 0) return after;
  const between = (axis: 0 | 1 | 2) => before[axis] + (after[axis] - before[axis]) * share;
  return [between(0), between(1), between(2)];
}

function positionOf(row: Float64Array): Vec3 {
  return [row[POSITION]!, row[POSITION + 1]!, row[POSITION + 2]!];
}

function worldOf({ bodies = [] }: PartialFrame): World {
  return {
    settings: valueOf(loadSettings({})),
    shipClasses: SHIP_CLASSES.map((one) => valueOf(loadShipClass(one))),
    bodies: bodies.map((one) => valueOf(loadBody(one))),
    terrainHeight: TERRAINS['hills']!,
    terrainNormals: TERRAIN_NORMALS,
  };
}
