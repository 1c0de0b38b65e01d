import { Group, Quaternion, Vector3 } from 'three';
import { createGhost, type Ghost } from '../overlays/ghost';
import type { ShipActor } from './shipActor';

/** The ships that are drawn as translucent hulls: few, since each takes a draw call. */
export interface TranslucentShips {
  readonly group: Group;
  /** Begins a frame without ships. */
  clear(): void;
  /** Puts a posed ship in the scene. `eye` local, m. */
  put(actor: ShipActor, eye: Float64Array): void;
  dispose(): void;
}

/** 0xrrggbb: no other mark in the picture has this colour. */
const COLOUR = 0xdcb4ff;

export function createTranslucentShips(): TranslucentShips {
  const group = new Group();
  const place = new Vector3();
  const turn = new Quaternion();
  const ghosts: Ghost[] = [];
  let count = 0;
  const next = () => {
    const known = ghosts[count++];
    if (known !== undefined) return known;
    const made = createGhost(COLOUR);
    ghosts.push(made);
    group.add(made.group);
    return made;
  };
  return {
    group,
    clear() {
      count = 0;
      for (const ghost of ghosts) ghost.show(false, place, turn);
    },
    put(actor, eye) {
      const ghost = next();
      ghost.setHull(actor.model.geometry);
      place.set(actor.place[0]! - eye[0]!, actor.place[1]! - eye[1]!, actor.place[2]! - eye[2]!);
      ghost.show(true, place, turn.fromArray(actor.turn));
    },
    dispose() {
      for (const ghost of ghosts) ghost.dispose();
    },
  };
}
