/** One direction of one stick, to which a key is bound. Axes are the ship's: pitch about x, yaw about y, roll about z. */
export type RotationAction = 'pitchPlus' | 'pitchMinus' | 'yawPlus' | 'yawMinus' | 'rollPlus' | 'rollMinus';

/** The same for the translation thrusters, along the ship's axes. */
export type TranslationAction =
  | 'translateXPlus'
  | 'translateXMinus'
  | 'translateYPlus'
  | 'translateYMinus'
  | 'translateZPlus'
  | 'translateZMinus';

/** Per body axis [+, −]: the action whose input on that axis is +1 or −1. */
export const ROTATION_ACTIONS: readonly (readonly [RotationAction, RotationAction])[] = [
  ['pitchPlus', 'pitchMinus'],
  ['yawPlus', 'yawMinus'],
  ['rollPlus', 'rollMinus'],
];
export const TRANSLATION_ACTIONS: readonly (readonly [TranslationAction, TranslationAction])[] = [
  ['translateXPlus', 'translateXMinus'],
  ['translateYPlus', 'translateYMinus'],
  ['translateZPlus', 'translateZMinus'],
];

/** Every action that a hint may name; 'rateDamping' is the game's attitude_hold. */
export type HintAction = RotationAction | TranslationAction | 'rateDamping';
