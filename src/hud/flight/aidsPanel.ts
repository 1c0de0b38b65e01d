import { DURATION, type LandingAids, SPEED, VERTICAL_SPEED } from '../../readout';
import { append, appendReading } from '../elements';
import { showAttribute, showNumber, showPart, showText } from '../shown';

const CORRIDOR = { slow: 'slow', good: 'on speed', fast: 'TOO FAST', none: '' } as const;

/** Landing aids: the speed to come down at, when to brake at the latest, and the predicted touchdown. */
export function createAidsPanel(parent: Element): (aids: LandingAids, on: boolean) => void {
  const panel = append(parent, 'div', 'td-aids');
  const aim = appendReading(panel, 'AIM', 'aim');
  const paintAim = showNumber(aim, VERTICAL_SPEED);
  const corridor = append(aim, 'span', 'td-corridor');
  const paintCorridor = showText(corridor);
  const paintKind = showAttribute(corridor, 'data-corridor');
  const brake = appendReading(panel, 'BRAKE IN', 'brake');
  const paintBrake = showNumber(brake, DURATION);
  const paintLate = showAttribute(brake, 'data-late');
  const paintTouch = showNumber(appendReading(panel, 'TOUCH IN', 'touch'), DURATION);
  const at = appendReading(panel, 'AT', 'touchspeed');
  const paintVertical = showNumber(at, VERTICAL_SPEED);
  append(at, 'span', 'td-of', ' · ');
  const paintHorizontal = showNumber(at, SPEED);
  const paintShown = showPart(panel);
  return (aids, on) => {
    paintShown(on);
    if (!on) return;
    paintAim(aids.aimSpeed);
    paintCorridor(CORRIDOR[aids.corridor]);
    paintKind(aids.corridor);
    paintBrake(aids.burnSeconds);
    paintLate(aids.burnSeconds < 1 ? 'true' : 'false');
    paintTouch(aids.touchSeconds);
    paintVertical(aids.touchVertical);
    paintHorizontal(aids.touchHorizontal);
  };
}
