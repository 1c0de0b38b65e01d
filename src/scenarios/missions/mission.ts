import type { Scenario } from '../scenario';

/** A place to land, from the mission's site: m to the east and north, and the radius of its ring, m. */
export interface Pad {
  readonly east: number;
  readonly north: number;
  readonly radius: number;
}

/** When a mission is done. */
export type MissionGoal =
  /** Landed on every pad, in their order. */
  | { readonly kind: 'land' }
  /** Between two heights of the feet, m, for some game seconds. */
  | { readonly kind: 'hover'; readonly low: number; readonly high: number; readonly seconds: number }
  /** In flight over the pad, no higher than `below`, m, and slower than `speed`, m/s. */
  | { readonly kind: 'reach'; readonly below: number; readonly speed: number };

/** A task for a pilot, as data: a scenario's start, pads and a goal. */
export interface Mission {
  readonly scenario: Scenario;
  /** One sentence: what to do. */
  readonly goal: string;
  /** How, for the flight school; '' in a mission. Keys stand in braces by their action: {throttleUp}. */
  readonly how: string;
  readonly done: MissionGoal;
  readonly pads: readonly Pad[];
  /** A step of the flight school: it is not scored. */
  readonly isLesson: boolean;
  /** Flown on instruments: the picture is nearly dark. */
  readonly night: boolean;
  /** Hardest touch that meets the goal, m/s; absent where the goal names none. */
  readonly touchLimit?: number;
  /** Game seconds and kg of fuel that earn the full marks. */
  readonly parSeconds: number;
  readonly parFuel: number;
}
