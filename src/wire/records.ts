import type { Body, BodyMotion, Controls, Quat, Settings, ShipClass, Vec3 } from '../dynamics';

/** The checked, finite, plain records that later rooms use. SI units, ICRF, quaternions [x, y, z, w]. */

/** The game's ShipState. */
export interface ShipState {
  /** Unique in its world. */
  readonly shipId: string;
  /** The player that owns the ship. */
  readonly playerId: string;
  /** For display; any text. */
  readonly name: string;
  /** Name of one of the ship classes. */
  readonly shipClass: string;
  /** m, ICRF. */
  readonly position: Vec3;
  /** m/s, ICRF. */
  readonly velocity: Vec3;
  /** [x, y, z, w], unit: rotates ship axes into ICRF. */
  readonly attitude: Quat;
  /** rad/s, ICRF axes. */
  readonly angularVelocity: Vec3;
  /** −1 … 1 about ship x (pitch), y (yaw), z (roll). */
  readonly rotationInput: Vec3;
  /** −1 … 1 along ship x, y, z. */
  readonly translationInput: Vec3;
  /** 0 … 1. */
  readonly thrustLevel: number;
  /** Rate damping. */
  readonly attitudeHold: boolean;
  /** One of ATTITUDE_MODES, or a mode unknown to this client. */
  readonly attitudeMode: string;
  /** [x, y, z, w], for attitude mode hold. */
  readonly targetAttitude: Quat;
  /** kg */
  readonly fuel: number;
  /** kg */
  readonly mass: number;
  /** Momentum stored in the reaction wheels, N m s, body axes; null if the server does not send it. */
  readonly wheelMomentum: Vec3 | null;
  /** Height of the centre of mass above the feet, m; null if the server does not send it: the class's then applies. */
  readonly groundContactOffset: number | null;
  /** Name of the body that it touches; empty in flight. */
  readonly landedBodyName: string;
  /** One of SURFACE_STATES, or a state unknown to this client. */
  readonly surfaceContactState: string;
  /** m/s; null when the server does not send field 31 (it sent no relative position either, and the field reads 0). */
  readonly contactImpactSpeed: number | null;
  /** Empty when the server does not send field 32. */
  readonly referenceBody: string;
  /** m, relative to the reference body's centre, ICRF axes; null when the server does not send fields 33 and 34. */
  readonly relativePosition: Vec3 | null;
  /** m/s, likewise. */
  readonly relativeVelocity: Vec3 | null;
  /** The ship is destroyed until it is spawned again. */
  readonly crashed: boolean;
}

/** Controls in a state: the mode may be unknown to this client. */
export type StateControls = Omit<Controls, 'attitudeMode'> & Pick<ShipState, 'attitudeMode'>;

/** A body's constants and its motion at the frame's tick. */
export interface BodyState extends Body, BodyMotion {}

/** Something that happened in substep `substep` (from 0) of the interval that begins at tick `tick`. */
export interface WorldEvent {
  /** One of EVENT_NAMES, or an event unknown to this client. */
  readonly type: string;
  readonly shipId: string;
  readonly tick: number;
  /** null if the server sends only the tick. */
  readonly substep: number | null;
  /** Of ship.contact: a touch after a bounce, not the first of this contact. */
  readonly again?: boolean;
  readonly playerId?: string;
  /** The body touched. */
  readonly body?: string;
  /** Of ship.destroyed: "collision". */
  readonly reason?: string;
}

/** From the server, once: the world config. */
export interface Hello {
  readonly kind: 'hello';
  /** "major.minor" of the messages that the server speaks (PROTOCOL_VERSION); absent: "1.0". Another major is refused. */
  readonly protocolVersion?: string;
  readonly playerId: string;
  /** The player's ship; empty for a spectator. */
  readonly shipId: string;
  readonly settings: Settings;
  readonly shipClasses: readonly ShipClass[];
  readonly bodies: readonly BodyState[];
  /** One of TERRAINS in dynamics. */
  readonly terrain: string;
  readonly tick: number;
  /** Hz */
  readonly tickRate: number;
  /** Game s per wall s. */
  readonly timeScale: number;
  readonly inputGranularity: 'substep' | 'tick';
}

/** The last of this client's inputs that the server applied. */
export interface InputAcknowledgement {
  readonly seq: number;
  /** When it was applied; later than its stamp if it arrived late. */
  readonly tick: number;
  readonly substep: number;
  /** How long it arrived before the server simulated its stamp's substep, wall s; negative: late. */
  readonly margin: number;
}

/** From the server, once a tick: the world at tick boundary `tick`. */
export interface ServerFrame extends PartialFrame {
  readonly tickRate: number;
  /** Game s per wall s. */
  readonly timeScale: number;
  readonly paused: boolean;
  readonly bodies: readonly BodyState[];
  readonly events: readonly WorldEvent[];
  readonly lastInput: InputAcknowledgement | null;
}

/** A frame of which the server may send only tick and ships; absent members were not sent. */
export interface PartialFrame {
  readonly kind: 'frame';
  readonly tick: number;
  /** Hz; tickRate, timeScale and paused apply from this tick to the next. */
  readonly tickRate?: number;
  /** Game s per wall s. */
  readonly timeScale?: number;
  /** Game time at `tick`, s since 1970-01-01T00:00:00Z. */
  readonly gameTime?: number;
  readonly paused?: boolean;
  readonly bodies?: readonly BodyState[];
  readonly ships: readonly ShipState[];
  /** Of the interval that ended at `tick`. */
  readonly events?: readonly WorldEvent[];
  /** null: no input has been applied yet. */
  readonly lastInput?: InputAcknowledgement | null;
}

/** A pilot's controls from the start of substep `substep` of the interval that begins at tick `tick`. */
export interface InputRecord {
  /** 1, 2, 3, … */
  readonly seq: number;
  readonly tick: number;
  readonly substep: number;
  readonly controls: Controls;
}

export interface Pong {
  readonly kind: 'pong';
  /** The ping's id. */
  readonly id: number;
  /** Server time when it answered: tick, and wall seconds since that tick boundary. */
  readonly tick: number;
  readonly sinceTick: number;
}

/** From the client. */
export interface ClientFrame {
  readonly kind: 'inputs';
  readonly inputs: readonly InputRecord[];
}

export interface Ping {
  readonly kind: 'ping';
  readonly id: number;
}

export type ServerMessage = Hello | ServerFrame | Pong;
export type ClientMessage = ClientFrame | Ping;
