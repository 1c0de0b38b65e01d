import type { Group } from 'three';
import type { ShipView, WorldView } from '../../prediction';
import type { LocalFrame, Turn } from '../localFrame';
import { createActor, poseActor, removeActor, type ShipActor, type ShipResources } from './shipActor';

/** The drawn ships of one body, by id. */
export interface Actors {
  readonly byId: Map<string, ShipActor>;
  /** Number of frames posed so far. */
  count: number;
}

/** Where ships are posed. */
export interface ActorPlace {
  readonly frame: LocalFrame;
  readonly turn: Turn;
  /** The group that holds the jets that burn. */
  readonly jets: Group;
  readonly shipResources: ShipResources;
  readonly inAir: boolean;
}

export function createActors(): Actors {
  return { byId: new Map(), count: 0 };
}

/** Poses every ship of the watched ship's body; `posed` is called for each. Ships that are no longer in the view are removed. */
export function poseActors(
  actors: Actors,
  view: WorldView,
  body: number,
  place: ActorPlace,
  posed: (actor: ShipActor, ship: ShipView) => void,
): void {
  actors.count += 1;
  let present = 0;
  for (const ship of view.ships) {
    if (ship.body !== body) continue;
    const actor = actorOf(actors, ship, place);
    present += 1;
    actor.seen = actors.count;
    poseActor(actor, ship, view, place.frame, place.turn);
    showJets(actor, place.jets);
    posed(actor, ship);
  }
  if (present === actors.byId.size) return;
  for (const [id, actor] of actors.byId) if (actor.seen !== actors.count) leave(actors, id, place.jets);
}

/** Most of a fleet is at rest: three would go through the jets of each ship several times per frame. */
function showJets({ jets }: ShipActor, group: Group): void {
  if (jets.visible === (jets.parent !== null)) return;
  if (jets.visible) group.add(jets);
  else group.remove(jets);
}

function actorOf(actors: Actors, ship: ShipView, { shipResources, inAir, jets }: ActorPlace): ShipActor {
  const known = actors.byId.get(ship.shipId);
  if (known?.className === ship.shipClass.name) return known;
  if (known !== undefined) removeActor(known, jets);
  const made = createActor(ship, shipResources, inAir);
  actors.byId.set(ship.shipId, made);
  return made;
}

export function clearActors(actors: Actors, jets: Group): void {
  for (const id of actors.byId.keys()) leave(actors, id, jets);
}

function leave(actors: Actors, id: string, jets: Group): void {
  removeActor(actors.byId.get(id)!, jets);
  actors.byId.delete(id);
}
