import type { RecordingListeners, RecordingPanel } from '../../recording/recordingPanel';
import type { Dock } from './dock';

/** A dock whose code is loaded when the workshop opens or a recording plays. */
export interface LazyDock extends Dock {
  readonly load: () => void;
}

/** @param failed called when the code cannot be loaded; the next `load` tries again */
export function createLazyDock(host: Element, listeners: RecordingListeners, failed: () => void): LazyDock {
  let dock: Dock | null = null;
  let loading: Promise<void> | null = null;
  let playing: Parameters<RecordingPanel['showReplay']>[0] = null;
  const load = () => {
    loading ??= import('./dock').then(
      ({ createDock }) => {
        dock = createDock(host, listeners);
        dock.recording.showReplay(playing);
      },
      () => {
        loading = null;
        failed();
      },
    );
  };
  return {
    load,
    recording: {
      showLength: (seconds, hasDropped) => dock?.recording.showLength(seconds, hasDropped),
      showReplay(replay) {
        playing = replay;
        if (replay !== null) load();
        dock?.recording.showReplay(replay);
      },
      showPosition: (at, isPlaying, where) => dock?.recording.showPosition(at, isPlaying, where),
      showProgress: (share) => dock?.recording.showProgress(share),
    },
    follow: (view, now) => dock?.follow(view, now) ?? false,
    clear: () => dock?.clear(),
  };
}
