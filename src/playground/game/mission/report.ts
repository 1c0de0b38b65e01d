import type { WorldView } from '../../../prediction';
import type { Parts } from '../parts';

/** The page's state as attributes of the root element, for tests and screenshots. */
export function createReport(root: HTMLElement, parts: Parts): (view: WorldView) => void {
  // Not compared with the attributes: a page reads them slowly.
  const shown: Record<string, string> = {};
  const set = (name: string, text: string) => {
    if (shown[name] !== text) root.dataset[name] = shown[name] = text;
  };
  let run = '';
  return ({ own }) => {
    set('status', own === null ? '' : own.shownState === '' ? 'flight' : own.shownState);
    set('provenance', own?.provenance ?? '');
    set('phase', parts.game.tracker.mission() === null ? '' : parts.game.tracker.phase());
    const next = parts.live.hash();
    if (next === run) return;
    run = next;
    set('run', run);
    const [tick, hash] = run.split(':');
    parts.panel.showRun(
      run === '' ? '' : `State hash at tick ${tick!}: ${hash!}${parts.live.ended() ? ' (end)' : ''}`,
    );
  };
}
