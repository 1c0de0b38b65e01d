import { NEUTRAL_CONTROLS } from 'galaxy-touchdown';

/** Axes of rotationInput with the keys that turn one way and the other. */
const AXES = [
  ['pitch', 'S', 'W'],
  ['yaw', 'D', 'A'],
  ['roll', 'E', 'Q'],
];

/** The key of an action that the landing HUD names, such as pitchPlus; '' for none. */
export const keyLabel = (action) =>
  AXES.find(([axis]) => action.startsWith(axis))?.[action.endsWith('Plus') ? 1 : 2] ?? '';

/** The keyboard as controls: those keys turn, F and V step the throttle by 10 %, X cuts it, T is rate damping. */
export function createControls(target) {
  const held = new Set();
  const controls = { ...NEUTRAL_CONTROLS };
  target.addEventListener('keydown', ({ code, repeat }) => {
    held.add(code);
    if (code === 'KeyF') controls.thrustLevel = Math.min(1, controls.thrustLevel + 0.1);
    if (code === 'KeyV') controls.thrustLevel = Math.max(0, controls.thrustLevel - 0.1);
    if (code === 'KeyX') controls.thrustLevel = 0;
    if (code === 'KeyT' && !repeat) controls.attitudeHold = !controls.attitudeHold;
  });
  target.addEventListener('keyup', ({ code }) => held.delete(code));
  target.addEventListener('blur', () => held.clear());
  const way = (key) => Number(held.has(`Key${key}`));
  return () => ({ ...controls, rotationInput: AXES.map(([, plus, minus]) => way(plus) - way(minus)) });
}
