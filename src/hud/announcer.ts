import { type LandingReadout, STATUS_LOOKS, type StatusId } from '../readout';
import { append } from './elements';

/**
 * Announcements for screen readers: transitions that the server has confirmed, once each, in one role=status region;
 * TIPPED and CRASHED in a role=alert (HUD, Access). Never numbers, never a prediction that may be withdrawn.
 */
export function createAnnouncer(parent: Element): (readout: LandingReadout) => void {
  const status = append(parent, 'p', 'td-unseen');
  status.setAttribute('role', 'status');
  const alert = append(parent, 'p', 'td-unseen');
  alert.setAttribute('role', 'alert');
  let announced: StatusId = 'none';
  return (readout) => {
    if (readout.status === announced || readout.status === 'none' || readout.provenance !== 'confirmed')
      return;
    const first = announced === 'none';
    announced = readout.status;
    const alarming = announced === 'tipped' || announced === 'crashed';
    // The state at page load is read with the page; only a bad one is announced at once.
    if (first && !alarming) return;
    const word = STATUS_LOOKS[announced].word.toLowerCase();
    const text = `${readout.shipName}: ${word}`;
    (alarming ? alert : status).textContent = text;
    (alarming ? status : alert).textContent = '';
  };
}
