import type { SceneView } from '../../scene';

/** rad a CSS pixel of dragging; a key's turn, rad. */
const DRAG = 0.006;
const KEY_TURN = 0.09;

/** Turns and zooms the camera: dragging, wheel, two fingers; arrow keys, + and − while the picture has the focus. */
export function steerCamera(canvas: HTMLCanvasElement, stage: SceneView): void {
  canvas.tabIndex = 0;
  const fingers = new Map<number, { x: number; y: number }>();
  let spread = 0;
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    spread = 0;
  });
  canvas.addEventListener('pointermove', (event) => {
    const finger = fingers.get(event.pointerId);
    if (finger === undefined) return;
    if (fingers.size === 1)
      stage.turnCamera(DRAG * (event.clientX - finger.x), DRAG * (event.clientY - finger.y));
    finger.x = event.clientX;
    finger.y = event.clientY;
    if (fingers.size !== 2) return;
    const [a, b] = [...fingers.values()];
    const apart = Math.hypot(a!.x - b!.x, a!.y - b!.y);
    if (spread > 0 && apart > 0) stage.zoomCamera(spread / apart);
    spread = apart;
  });
  const lift = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    spread = 0;
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      stage.zoomCamera(Math.exp(Math.max(-1, Math.min(1, event.deltaY / 300))));
    },
    { passive: false },
  );
  canvas.addEventListener('keydown', (event) => {
    const turns: Readonly<Record<string, readonly [number, number]>> = {
      ArrowLeft: [-KEY_TURN, 0],
      ArrowRight: [KEY_TURN, 0],
      ArrowUp: [0, KEY_TURN],
      ArrowDown: [0, -KEY_TURN],
    };
    const turn = Object.hasOwn(turns, event.key) ? turns[event.key] : undefined;
    if (turn !== undefined) stage.turnCamera(turn[0], turn[1]);
    else if (event.key === '+' || event.key === '=') stage.zoomCamera(0.88);
    else if (event.key === '-') stage.zoomCamera(1 / 0.88);
    else if (event.key === 'Home') stage.resetCamera();
    else return;
    event.preventDefault();
  });
}
