import {
  ANGLE,
  DURATION,
  type Format,
  type HintAction,
  MASS,
  type Righting,
  type RotationAction,
  TORQUE,
} from '../../readout';
import { append } from '../elements';
import { showAttribute, showNumber, showPart, showText } from '../shown';

/** The text on the key that an action is bound to now; '' when it has none. Called at every paint. */
export type KeyLabel = (action: HintAction) => string;

/**
 * The controls that turn the ship about its own axes now, the better one first, for a page whose keys follow the camera: the
 * text printed on each, and a description of what it does.
 */
export type TurnKeys = (actions: readonly RotationAction[]) => readonly TurnKey[];

export interface TurnKey {
  /** '' where nothing is bound. */
  readonly cap: string;
  readonly words: string;
}

/** The design's words. */
const HINT = 'Use RCS rotation to right the ship';

const ACTION_WORDS: Readonly<Record<HintAction, string>> = {
  pitchPlus: 'pitch +',
  pitchMinus: 'pitch −',
  yawPlus: 'yaw +',
  yawMinus: 'yaw −',
  rollPlus: 'roll +',
  rollMinus: 'roll −',
  translateXPlus: 'thrusters +X',
  translateXMinus: 'thrusters −X',
  translateYPlus: 'thrusters +Y',
  translateYMinus: 'thrusters −Y',
  translateZPlus: 'thrusters +Z',
  translateZMinus: 'thrusters −Z',
  rateDamping: 'rate damping',
};

/** The control to press, whether it suffices, and otherwise what may help (HUD, Righting help). */
export function createRightingPanel(
  parent: Element,
  keyLabel: KeyLabel,
  turnKeys: TurnKeys = (actions) =>
    actions.map((action) => ({ cap: keyLabel(action), words: ACTION_WORDS[action] })),
): (righting: Righting) => void {
  const panel = append(parent, 'div', 'td-righting');
  append(panel, 'p', 'td-hint', HINT);
  const hold = append(panel, 'p', 'td-hold');
  append(hold, 'span', 'td-label', 'HOLD');
  const paintFirst = createTurnKey(hold);
  const paintSecond = createTurnKey(hold);
  const time = append(hold, 'span', 'td-of');
  const paintTime = showNumber(time, DURATION);
  const paintTimeShown = showPart(time);
  const then = append(panel, 'p', 'td-hold');
  append(then, 'span', 'td-label', 'RELEASE');
  const paintHoldShown = showPart(hold);
  const paintThenShown = showPart(then);
  // If they are held longer, the swing carries the ship over to its other side.
  const until = append(then, 'span', 'td-until', 'below ');
  const paintUntil = showNumber(until, ANGLE);
  const paintUntilShown = showPart(until);
  const paintNow = showPart(append(then, 'strong', '', 'now'));
  const press = append(then, 'span', '', 'then press');
  const paintPressShown = showPart(press);
  const paintDamping = createKey(then, keyLabel);
  const paintTorque = createTorque(panel);
  const paintFuel = createFuel(panel);
  const paintVerdict = createVerdict(panel, keyLabel);
  const paintShown = showPart(panel);
  return (righting) => {
    paintShown(righting.shown);
    if (!righting.shown) return;
    paintHoldShown(righting.possible);
    paintThenShown(righting.possible);
    const keys = turnKeys(righting.actions);
    paintFirst(keys[0] ?? null);
    paintSecond(keys[1] ?? null);
    paintTime(righting.holdSeconds);
    paintTimeShown(righting.outcome === 'lands');
    paintUntil(righting.holdUntil);
    paintUntilShown(!righting.release);
    paintNow(righting.release);
    paintPressShown(!righting.damped);
    paintDamping(righting.damped ? '' : 'rateDamping');
    paintTorque(righting);
    paintFuel(righting);
    paintVerdict(righting);
  };
}

function createTurnKey(parent: Element): (key: TurnKey | null) => void {
  const holder = append(parent, 'span', 'td-action');
  const cap = append(holder, 'kbd');
  const paintCapShown = showPart(cap);
  const paintCap = showText(cap);
  const paintWords = showText(append(holder, 'span'));
  const paintShown = showPart(holder);
  return (key) => {
    paintShown(key !== null);
    if (key === null) return;
    paintCapShown(key.cap !== '');
    paintCap(key.cap);
    paintWords(key.words);
  };
}

function createKey(parent: Element, keyLabel: KeyLabel): (action: HintAction | '') => void {
  const holder = append(parent, 'span', 'td-action');
  const cap = append(holder, 'kbd');
  const paintCapShown = showPart(cap);
  const paintCap = showText(cap);
  const paintAxis = showText(append(holder, 'span'));
  const paintShown = showPart(holder);
  return (action) => {
    paintShown(action !== '');
    if (action === '') return;
    const label = keyLabel(action);
    paintCapShown(label !== '');
    paintCap(label);
    paintAxis(ACTION_WORDS[action]);
  };
}

/** `55 kN m of 142 kN m`: needed of available, as in every line. */
function createTorque(parent: Element): (righting: Righting) => void {
  const { paintNeeded, paintAvailable, paintMark } = createNeed(parent, 'TORQUE', TORQUE);
  return (righting) => {
    paintAvailable(righting.torqueAvailable);
    paintNeeded(righting.torqueNeeded);
    paintMark(righting.possible ? 'true' : 'false');
  };
}

/** `39 kg of 7 200 kg`, from simulating ahead. */
function createFuel(parent: Element): (righting: Righting) => void {
  const { line, paintNeeded, paintAvailable, paintMark } = createNeed(parent, 'FUEL', MASS);
  const paintShown = showPart(line);
  return (righting) => {
    paintShown(righting.possible);
    paintNeeded(righting.fuelNeeded);
    paintAvailable(righting.fuel);
    paintMark(righting.outcome === 'working' ? 'unknown' : righting.outcome === 'lands' ? 'true' : 'false');
  };
}

/** A line with two numbers, needed and available, and a mark: enough or not. */
function createNeed(parent: Element, label: string, format: Format) {
  const line = append(parent, 'p', 'td-need');
  append(line, 'span', 'td-label', label);
  const values = append(line, 'span', 'td-value');
  const paintNeeded = showNumber(values, format);
  append(values, 'span', 'td-of', ' of ');
  const paintAvailable = showNumber(values, format);
  return { line, paintNeeded, paintAvailable, paintMark: createMark(line) };
}

function createMark(line: Element): (met: 'true' | 'false' | 'unknown') => void {
  const mark = append(line, 'span', 'td-tick');
  mark.setAttribute('role', 'img');
  const paintMark = showText(mark);
  const paintLabel = showAttribute(mark, 'aria-label');
  const paintMet = showAttribute(line, 'data-met');
  return (met) => {
    paintMet(met);
    paintMark(met === 'unknown' ? '' : met === 'true' ? '✓' : '✗');
    paintLabel(met === 'unknown' ? 'not known' : met === 'true' ? 'enough' : 'not enough');
  };
}

/** Shown only where the ship cannot be righted as it is, with what may help. */
function createVerdict(parent: Element, keyLabel: KeyLabel): (righting: Righting) => void {
  const line = append(parent, 'p', 'td-verdict');
  const paintText = showText(append(line, 'span'));
  const paintKey = createKey(line, keyLabel);
  const mass = append(line, 'span');
  const paintMass = showNumber(mass, MASS);
  const paintMassShown = showPart(mass);
  const paintShown = showPart(line);
  return (righting) => {
    const stuck = !righting.possible || righting.outcome === 'fails';
    paintShown(stuck);
    if (!stuck) return;
    paintText(verdict(righting));
    paintKey(righting.possible ? '' : righting.helpAction);
    const lighter = !righting.possible && righting.help === 'lighter';
    paintMassShown(lighter);
    if (lighter) paintMass(righting.helpMass);
  };
}

function verdict({ possible, help }: Righting): string {
  if (possible) return 'In simulation the ship does not stay upright: it runs out of fuel or falls over.';
  if (help === 'translation') return 'Too heavy to turn. Take weight off its feet with';
  if (help === 'lighter') return 'Too heavy to turn. Burn fuel until it weighs less than';
  return 'It cannot be righted here: nothing on board can turn this weight.';
}
