import {
  DURATION,
  type LandingReadout,
  provenanceText,
  STATUS_LOOKS,
  type StatusId,
  withdrawnText,
} from '../../readout';
import { append } from '../elements';
import { showAttribute, showText } from '../shown';

/** The one fixed slot: shape, word and colour together, and beside them how far they can be trusted (HUD). */
export function createStatusSlot(parent: Element): (readout: LandingReadout) => void {
  const slot = append(parent, 'div', 'td-status');
  const shape = append(slot, 'span', 'td-shape');
  shape.setAttribute('aria-hidden', 'true');
  const paintShape = showText(shape);
  const paintWord = showText(append(slot, 'strong', 'td-word'));
  const provenance = append(slot, 'span', 'td-provenance');
  const paintProvenance = createProvenance(provenance);
  const paintProvenanceKind = showAttribute(provenance, 'data-provenance');
  const paintColour = showAttribute(slot, 'data-colour');
  const paintKnown = showAttribute(slot, 'data-known');
  const pulse = createPulse(slot);
  const paintWithdrawn = showText(append(parent, 'p', 'td-withdrawn'));
  return (readout) => {
    const look = STATUS_LOOKS[readout.status];
    paintShape(look.shape);
    paintWord(look.word);
    paintColour(look.colour);
    paintKnown(readout.known ? 'true' : 'false');
    paintProvenanceKind(readout.provenance);
    paintProvenance(readout);
    pulse(readout.status);
    paintWithdrawn(withdrawnText(readout.withdrawn));
  };
}

/** The text is built only when a part of it changed: the age changes only ten times per second. */
function createProvenance(parent: Element): (readout: LandingReadout) => void {
  const paint = showText(parent);
  let kind = '';
  let status = '';
  let age = NaN;
  let scale = NaN;
  return (readout) => {
    const key = DURATION.key(readout.age);
    if (
      kind === readout.provenance &&
      status === readout.status &&
      age === key &&
      scale === readout.timeScale
    )
      return;
    kind = readout.provenance;
    status = readout.status;
    age = key;
    scale = readout.timeScale;
    paint(provenanceText(readout, key));
  };
}

/** One 300 ms pulse when a ground state begins; the style sheet leaves it out under prefers-reduced-motion. */
function createPulse(slot: Element): (status: StatusId) => void {
  let shown: StatusId = 'none';
  let beat = false;
  return (status) => {
    if (status === shown) return;
    const first = shown === 'none';
    shown = status;
    if (first || status === 'flight' || status === 'none') return;
    // Two identical animations: only another name restarts it.
    beat = !beat;
    slot.setAttribute('data-pulse', beat ? 'a' : 'b');
  };
}
