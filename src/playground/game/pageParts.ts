import type { SceneView } from '../../scene';
import type { KeySettings } from '../input/keyTable';
import type { Banner } from '../panels/banner';
import type { Choices } from '../panels/choices';
import type { Notice } from '../panels/notice';
import type { Resolution } from '../view/resolution';
import type { Address } from './address';
import type { Runs } from './mission/runs';

/** Parts of the page that exist before anything runs. */
export interface Page {
  readonly document: Document;
  readonly window: Window & typeof globalThis;
  /** Address of the main module, which the worker runs too. */
  readonly program: string;
  /** The built-in server, if the page begins with it. */
  readonly worker: Worker | null;
  readonly part: (id: string) => HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly sceneView: SceneView | null;
  readonly notice: Notice;
  readonly banner: Banner;
  readonly choices: Choices;
  readonly store: Storage | null;
  keys: KeySettings;
  readonly address: Address;
  readonly runs: Runs;
  /** null: always at its finest. */
  readonly resolution: Resolution | null;
  /** The query of the present choices. */
  readonly query: () => string;
}
