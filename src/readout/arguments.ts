import type { WorldView } from '../prediction';

/** Stands in until there is a view. */
const NO_VIEW = { ready: false, own: null, ships: [], timeScale: 1 } as unknown as WorldView;

/**
 * The view to read: one that is not ready for null and undefined, as of a predictor in a worker that has not answered yet.
 * @throws TypeError, naming the call, where the two arguments are the wrong way round, or one ship's view is passed for the world's
 */
export function viewOf(call: string, out: object, view: WorldView | null | undefined): WorldView {
  if (
    (out as object | null | undefined) === null ||
    (out as object | undefined) === undefined ||
    'diagnosis' in out
  )
    throw new TypeError(`${call}(readout, view): expected the readout first, then the view`);
  if (view === null || view === undefined) return NO_VIEW;
  if (!('ships' in view))
    throw new TypeError(`${call}(readout, view): expected all that predictor.view returns`);
  return view;
}
