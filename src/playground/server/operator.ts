import type { Vec3 } from '../../dynamics';
import { siteToIcrf } from '../../scenarios';
import type { BodyState } from '../../wire';
import { type LoadedWorld, OWN_PLAYER, OWN_SHIP } from './loadedWorld';
import type { LoadOperation, Operation } from './operation';
import { movedTo, saveShips, stateNow } from './savedShips';

/** Carries out a command of the operator. Returns the reason why not, or null. */
export function operateWorld(
  world: LoadedWorld,
  operation: Exclude<Operation, LoadOperation>,
  now: number,
): string | null {
  const { link } = world;
  const { authority } = link;
  switch (operation.kind) {
    case 'pause':
      authority.setPaused(operation.paused);
      return null;
    case 'step':
      return link.step(operation.unit, now);
    case 'tickRate':
      return authority.setTickRate(operation.tickRate);
    case 'timeScale':
      return authority.setTimeScale(operation.timeScale);
    case 'restart':
      return authority.respawn(OWN_SHIP);
    case 'kick':
      return kick(world, operation.velocity, operation.spin);
    case 'snapshot':
      return snapshot(world);
    case 'restore':
      return restore(world);
    case 'drag':
      return drag(world, operation.offset, operation.begins);
    case 'run':
    case 'invite':
      return null;
    default:
      return operateNetwork(world, operation, now);
  }
}

type NetworkOperation = Extract<
  Operation,
  { readonly kind: 'network' | 'spike' | 'freeze' | 'drop' | 'reconnect' }
>;

function operateNetwork(world: LoadedWorld, operation: NetworkOperation, now: number): null {
  const { link } = world;
  switch (operation.kind) {
    case 'network':
      link.setNetwork(operation.numbers, operation.up);
      break;
    case 'spike':
      link.stall(now + operation.seconds);
      break;
    case 'freeze':
      link.setFrozen(operation.frozen, now);
      break;
    case 'drop':
      link.drop(OWN_PLAYER);
      world.isConnected = false;
      break;
    case 'reconnect':
      link.reconnect(OWN_PLAYER, now);
      world.isConnected = true;
      break;
  }
  return null;
}

function kick({ loaded, link }: LoadedWorld, velocity: Vec3, spin: Vec3): string | null {
  const motion = link.authority.frameFor(OWN_PLAYER)?.bodies[0] ?? loaded.body;
  const ground = { body: motion, site: loaded.scenario.site, terrainHeight: loaded.terrainHeight };
  return link.authority.kick(OWN_SHIP, siteToIcrf(velocity, ground), siteToIcrf(spin, ground));
}

function snapshot(world: LoadedWorld): string | null {
  const frame = world.link.authority.frameFor(OWN_PLAYER);
  if (frame === null) return 'snapshot: the player has no ship';
  const saved = saveShips(frame);
  if (!saved.ok) return `snapshot: ${saved.reason}`;
  world.saved = saved.value;
  return null;
}

function restore(world: LoadedWorld): string | null {
  const { saved, link } = world;
  if (saved === null) return 'restore: take a snapshot first';
  for (const ship of saved) {
    const body = bodyOf(world, ship.state.referenceBody);
    // A guest that has left is not restored.
    if (body !== null) link.authority.respawn(ship.shipId, stateNow(ship, body));
  }
  return null;
}

/** The offset is from the ship's position at the start of the drag. */
function drag(world: LoadedWorld, offset: Vec3, begins: boolean): string | null {
  const { authority } = world.link;
  if (begins || world.dragged === null) {
    const frame = authority.frameFor(OWN_PLAYER);
    const saved = frame === null ? null : saveShips(frame);
    if (saved?.ok !== true) return 'drag: no ship to move';
    world.dragged = saved.value.find(({ shipId }) => shipId === OWN_SHIP) ?? null;
  }
  const { dragged } = world;
  const body = dragged === null ? null : bodyOf(world, dragged.state.referenceBody);
  if (dragged === null || body === null) return 'drag: no ship to move';
  return authority.respawn(OWN_SHIP, movedTo(dragged, body, offset));
}

function bodyOf({ link }: LoadedWorld, name: string): BodyState | null {
  return link.authority.frameFor(OWN_PLAYER)?.bodies.find((body) => body.name === name) ?? null;
}
