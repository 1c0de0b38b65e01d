import { CAMERA_VIEWS, type CameraView, type SceneView } from '../../scene';
import type { Banner } from '../panels/banner';

/** The page's message for each camera. */
const WORDS: Readonly<Record<CameraView, string>> = {
  follow: 'Camera: around the ship. Drag to turn it.',
  chase: 'Camera: behind the ship.',
  cockpit: 'Camera: from the cockpit.',
  above: 'Camera: from above.',
  free: 'Camera: fixed.',
};

/** Each call selects the next camera and shows its name. */
export function createCameraSwitch(sceneView: SceneView | null, banner: Banner): () => void {
  let at = 0;
  return () => {
    at = (at + 1) % CAMERA_VIEWS.length;
    sceneView?.setCamera(CAMERA_VIEWS[at]!);
    banner.flash(WORDS[CAMERA_VIEWS[at]!]);
  };
}
