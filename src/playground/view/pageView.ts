import type { WorldView } from '../../prediction';
import type { Recording } from '../../scenarios';
import { createRecorder, type Recorder } from '../recording/recorder';
import type { RecordingListeners, RecordingPanel } from '../recording/recordingPanel';
import type { Replay } from '../recording/replay';
import type * as Replaying from '../recording/replaying';

/** Recording and replaying: what the page shows instead of the game while a recording plays. */
export interface PageView {
  readonly recorder: Recorder;
  readonly listeners: RecordingListeners;
  /** The replay that is on, or null. */
  readonly replay: () => Replay | null;
  /** The replay's view after `seconds` of playing, once a frame. */
  readonly frame: (seconds: number) => WorldView | null;
  readonly load: (file: File) => void;
  readonly leave: () => void;
}

export interface PageViewPlace {
  readonly panel: () => RecordingPanel;
  readonly note: () => string;
  readonly tell: (text: string) => void;
  readonly banner: (text: string) => void;
  /** A replay begins or ends. */
  readonly changed: (on: boolean) => void;
}

export function createPageView(place: PageViewPlace): PageView {
  const recorder = createRecorder();
  let replay: Replay | null = null;
  let playing = true;
  /** Counts what was asked for: whoever comes back from a fetch checks whether it is still wanted. */
  let request = 0;

  const open = async (recording: Recording) => {
    if (recording.entries.length === 0) {
      place.tell('Nothing is recorded yet: let the game run for a moment first.');
      return;
    }
    const mine = ++request;
    const part = await fetchPart(place);
    if (part === null || mine !== request) return;
    replay = part.createReplay(recording);
    playing = true;
    replay.seek(replay.from);
    place.panel().showReplay(replay);
    place.banner('Replay');
    place.changed(true);
  };
  const leave = () => {
    request += 1;
    if (replay === null) return;
    replay = null;
    place.panel().showReplay(null);
    place.banner('');
    place.changed(false);
  };
  const save = async () => {
    const panel = place.panel();
    const recording = recorder.recording(place.note());
    const part = await fetchPart(place);
    if (part === null) return;
    const blob = await part.writeSlowly(recording, panel.showProgress);
    panel.showProgress(null);
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = 'touchdown.jsonl';
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  };
  const load = async (file: File) => {
    place.banner(`Reading ${file.name} …`);
    const part = await fetchPart(place);
    const read = await part?.readFile(file);
    place.banner('');
    if (part === null || read === undefined) return;
    if (read.ok) await open(read.value);
    else place.tell(part.refusalWords(file.name, read));
  };

  return {
    recorder,
    replay: () => replay,
    leave,
    load: (file) => void load(file),
    listeners: {
      replay: () => void open(recorder.recording(place.note())),
      leave,
      save: () => void save(),
      load: (file) => void load(file),
      seek(at) {
        playing = false;
        replay?.seek(at);
      },
      play(next) {
        playing = next;
        if (playing && replay !== null && replay.position() >= replay.to) replay.seek(replay.from);
      },
    },
    frame(seconds) {
      if (replay === null) {
        place.panel().showLength(recorder.seconds(), recorder.full());
        return null;
      }
      const view = replay.seek(replay.position() + (playing ? seconds : 0));
      if (replay.position() >= replay.to) playing = false;
      place.panel().showPosition(replay.position(), playing);
      return view;
    },
  };
}

/** The code that plays, reads and writes recordings; says so where it does not load. */
async function fetchPart({ tell }: PageViewPlace): Promise<typeof Replaying | null> {
  try {
    return await import('../recording/replaying');
  } catch {
    tell('Part of the page did not load; reload it with the network on.');
    return null;
  }
}

/** Lets recordings be dropped anywhere on the page. */
export function takeDrops(body: HTMLElement, load: (file: File) => void): void {
  body.addEventListener('dragover', (event) => {
    event.preventDefault();
    body.classList.add('dropping');
  });
  body.addEventListener('dragleave', () => body.classList.remove('dropping'));
  body.addEventListener('drop', (event) => {
    event.preventDefault();
    body.classList.remove('dropping');
    const file = event.dataTransfer?.files[0];
    if (file !== undefined) load(file);
  });
}
