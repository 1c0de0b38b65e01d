import type { WorldView } from '../prediction';

/** The view that is read before there is one. */
const NO_VIEW = { ready: false, own: null, ships: [], timeScale: 1 } as unknown as WorldView;

/**
 * The view to read: one that is not ready for null and undefined, as of a predictor in a worker that has not answered yet.
 * @throws TypeError, naming the call, where the two arguments are the wrong way round
 */
export function viewOf(call: string, out: object, view: WorldView | null | undefined): WorldView {
  if (
    (out as object | null | undefined) === null ||
    (out as object | undefined) === undefined ||
    'diagnosis' in out
  )
    throw new TypeError(`${call}(readout, view): expected the readout first, then the view`);
  return view ?? NO_VIEW;
}
