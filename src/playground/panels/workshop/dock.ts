import './dock.css';
import type { WorldView } from '../../../prediction';
import { append, appendDetails } from '../elements';
import { createFigures } from './figures';
import { createNetStrip } from './netStrip';
import { createPlots } from './plots';
import {
  createRecordingPanel,
  type RecordingListeners,
  type RecordingPanel,
} from '../../recording/recordingPanel';
import { createSamples } from '../../game/samples';

/** The dock along the bottom: frames by class, figures, plots, recording. */
export interface Dock {
  readonly recording: RecordingPanel;
  /** Called once per frame; paints ten times per second, and returns whether it has. */
  readonly follow: (view: WorldView, now: number) => boolean;
  readonly clear: () => void;
}

export function createDock(host: Element, listeners: RecordingListeners): Dock {
  const strip = createNetStrip(host);
  const parts = append(host, 'div', 'parts');
  const figuresPart = appendDetails(parts, 'Figures', false);
  const paintFigures = createFigures(figuresPart);
  const plotsPart = appendDetails(parts, 'Plots', false);
  const paintPlots = createPlots(plotsPart);
  const recordingPart = appendDetails(parts, 'Recording', false);
  const recording = createRecordingPanel(recordingPart, listeners);
  const samples = createSamples();
  return {
    recording,
    follow({ diagnosis }, now) {
      strip.watch(diagnosis, now);
      if (!samples.take(diagnosis, now)) return false;
      strip.paint(diagnosis, now);
      if (figuresPart.open) paintFigures(samples);
      if (plotsPart.open) paintPlots(samples);
      return true;
    },
    clear() {
      strip.clear();
      samples.clear();
    },
  };
}
