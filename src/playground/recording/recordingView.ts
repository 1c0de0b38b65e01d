import type { WorldView } from '../../prediction';
import type { Recording } from '../../scenarios';
import { createRecorder, type Recorder } from './recorder';
import type { RecordingListeners, RecordingPanel } from './recordingPanel';
import { createReplayDeck, type ReplayDeck } from './replayDeck';
import type * as Replaying from './replaying';

/** Recording and replaying: the page's view in place of the game while a recording plays. */
export interface RecordingView {
  readonly recorder: Recorder;
  readonly listeners: RecordingListeners;
  /** The replay, if one plays. */
  readonly deck: ReplayDeck;
  /** The replay's view after `seconds` of playing, once a frame. */
  readonly frame: (seconds: number) => WorldView | null;
  readonly load: (file: File) => void;
  readonly leave: () => void;
}

export interface RecordingViewContext {
  readonly panel: () => RecordingPanel;
  readonly note: () => string;
  readonly notify: (text: string) => void;
  readonly banner: (text: string) => void;
  /** A replay begins or ends. */
  readonly changed: (on: boolean) => void;
}

export function createRecordingView(context: RecordingViewContext): RecordingView {
  const recorder = createRecorder();
  const deck = createReplayDeck(context.panel);
  /** Counts requests: one that comes back from a fetch is dropped if another came after it. */
  let request = 0;

  const open = async (recording: Recording) => {
    if (recording.entries.length === 0) {
      context.notify('Nothing is recorded yet: let the game run first.');
      return;
    }
    const mine = ++request;
    const part = await fetchPart(context);
    if (part === null || mine !== request) return;
    const replay = part.createReplay(recording);
    deck.insert(recording, replay);
    context.panel().showReplay(replay);
    context.banner('Replay');
    context.changed(true);
  };
  const leave = () => {
    request += 1;
    if (deck.replay() === null) return;
    deck.eject();
    context.panel().showReplay(null);
    context.banner('');
    context.changed(false);
  };
  const load = async (file: File) => {
    context.banner(`Reading ${file.name} …`);
    const part = await fetchPart(context);
    const read = await part?.readFile(file);
    context.banner('');
    if (part === null || read === undefined) return;
    if (read.ok) await open(read.value);
    else context.notify(part.refusalWords(file.name, read));
  };
  const record = () => recorder.recording(context.note());
  return {
    recorder,
    deck,
    leave,
    load: (file) => void load(file),
    listeners: {
      ...deck.controls,
      replay: () => void open(record()),
      leave,
      save: () => void save(context, record()),
      load: (file) => void load(file),
    },
    frame(seconds) {
      const view = deck.frame(seconds);
      if (view === null) context.panel().showLength(recorder.seconds(), recorder.hasDropped());
      return view;
    },
  };
}

async function save(context: RecordingViewContext, recording: Recording): Promise<void> {
  const panel = context.panel();
  const part = await fetchPart(context);
  if (part === null) return;
  const blob = await part.writeInSlices(recording, panel.showProgress);
  panel.showProgress(null);
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = part.fileName(recording, new Date());
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** The code that plays, reads and writes recordings; shows a message if it does not load. */
async function fetchPart({ notify: tell }: RecordingViewContext): Promise<typeof Replaying | null> {
  try {
    return await import('./replaying');
  } catch {
    tell('Part of the page did not load. Check the network and reload.');
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
