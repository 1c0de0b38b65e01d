import type { ShipDrag } from './shipDrag';
import type { SceneView } from '../../scene';

/** rad per CSS pixel of dragging; a key's turn, rad. */
const DRAG = 0.006;
const KEY_TURN = 0.09;
/** A key that zooms in multiplies the camera's distance by this; CSS pixels of the wheel for a factor of e. */
const KEY_ZOOM = 0.88;
const WHEEL = 300;

/** Turns and zooms the camera: dragging, wheel, two fingers; arrow keys, + and − while the picture has the focus. */
export function steerCamera(canvas: HTMLCanvasElement, scene: SceneView, shipDrag: ShipDrag): void {
  canvas.tabIndex = 0;
  listenToPointers(canvas, scene, shipDrag);
  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      scene.zoomCamera(Math.exp(Math.max(-1, Math.min(1, event.deltaY / WHEEL))));
    },
    { passive: false },
  );
  listenToArrows(canvas, scene);
}

/** One finger turns the camera, or moves the ship while that is on; two zoom. */
function listenToPointers(canvas: HTMLCanvasElement, scene: SceneView, shipDrag: ShipDrag): void {
  const fingers = new Map<number, { x: number; y: number }>();
  let spread = 0;
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (shipDrag.isOn() && fingers.size === 1) shipDrag.begin();
  });
  canvas.addEventListener('pointermove', (event) => {
    const finger = fingers.get(event.pointerId);
    if (finger === undefined) return;
    const [right, down] = [event.clientX - finger.x, event.clientY - finger.y];
    if (fingers.size === 1 && shipDrag.isOn()) shipDrag.move(right, down);
    else if (fingers.size === 1) scene.turnCamera(DRAG * right, DRAG * down);
    finger.x = event.clientX;
    finger.y = event.clientY;
    if (fingers.size !== 2) return;
    const [a, b] = [...fingers.values()];
    const apart = Math.hypot(a!.x - b!.x, a!.y - b!.y);
    if (spread > 0 && apart > 0) scene.zoomCamera(spread / apart);
    spread = apart;
  });
  const lift = (event: PointerEvent) => {
    fingers.delete(event.pointerId);
    spread = 0;
    shipDrag.end();
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);
}

function listenToArrows(canvas: HTMLCanvasElement, scene: SceneView): void {
  canvas.addEventListener('keydown', (event) => {
    const turns: Readonly<Record<string, readonly [number, number]>> = {
      ArrowLeft: [-KEY_TURN, 0],
      ArrowRight: [KEY_TURN, 0],
      ArrowUp: [0, KEY_TURN],
      ArrowDown: [0, -KEY_TURN],
    };
    const turn = Object.hasOwn(turns, event.key) ? turns[event.key] : undefined;
    if (turn !== undefined) scene.turnCamera(turn[0], turn[1]);
    else if (event.key === '+' || event.key === '=') scene.zoomCamera(KEY_ZOOM);
    else if (event.key === '-') scene.zoomCamera(1 / KEY_ZOOM);
    else if (event.key === 'Home') scene.resetCamera();
    else return;
    event.preventDefault();
  });
}
