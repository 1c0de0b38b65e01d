/** Called once per code with the reason why a HUD cannot be seen, and with advice. */
export type HudWarn = (code: string, message: string) => void;

const CHOICES = { theme: ['dark', 'light', 'system'], layout: ['auto', 'full', 'compact'] } as const;

const DOCUMENT_NODE = 9;
const FUNCTIONS = ['keyLabel', 'turnKeys', 'onWarning'];

/** Throws RangeError that names the invalid argument or option; warns of options that do not exist. */
export function requireHost(document: Document, host: Element | ShadowRoot, given: object): void {
  if (!has(document, 'createElement'))
    throw new RangeError(`document: expected the page's document first, got ${kindOf(document)}`);
  if (!has(host, 'append'))
    throw new RangeError(
      `host: expected an element or a shadow root, got ${kindOf(host)}. Is it in the page when this runs?`,
    );
  if ((host as Node).nodeType === DOCUMENT_NODE)
    throw new RangeError('host: expected an element or a shadow root, got the document: pass its body');
  if (typeof given !== 'object' || (given as object | null) === null)
    throw new RangeError(`options: expected an object, got ${kindOf(given)}`);
  const options = given as Readonly<Record<string, unknown>>;
  for (const name of FUNCTIONS)
    if (options[name] !== undefined && typeof options[name] !== 'function')
      throw new RangeError(`options.${name}: expected a function, got ${kindOf(options[name])}`);
  for (const [name, choices] of Object.entries(CHOICES)) {
    const value = options[name];
    if (value !== undefined && !(choices as readonly unknown[]).includes(value))
      throw new RangeError(`options.${name}: expected ${choices.join(', ')}, got ${JSON.stringify(value)}`);
  }
  const known = [...Object.keys(CHOICES), ...FUNCTIONS];
  const unknown = Object.keys(options).filter((name) => !known.includes(name));
  if (unknown.length > 0)
    (options['onWarning'] as HudWarn | undefined)?.(
      'hud-option',
      `options.${unknown.join(', ')}: unknown and ignored. Known: ${known.join(', ')}.`,
    );
}

function has(value: unknown, method: string): boolean {
  return typeof (value as Readonly<Record<string, unknown>> | null | undefined)?.[method] === 'function';
}

/** 'Null', 'Undefined', 'String', 'HTMLDocument', … */
function kindOf(value: unknown): string {
  return Object.prototype.toString.call(value).slice(8, -1);
}

/** A HUD's element and painter, and how its readout is recognised. */
interface Painted<Readout> {
  readonly root: HTMLElement;
  readonly paint: (readout: Readout) => void;
  readonly dispose: () => void;
  /** Members that every such readout has, and the function that creates one. */
  readonly members: readonly (keyof Readout & string)[];
  readonly madeBy: string;
}

/** Number of paints after which the style sheet must have loaded. */
const PAINTS = 60;

/**
 * Wraps a painter: anything but a readout, and calls after `dispose`, are ignored with a warning. Also warns if something keeps the HUD
 * from being seen.
 */
export function checked<Readout>(
  { root, paint, dispose, members, madeBy }: Painted<Readout>,
  onWarning: HudWarn | undefined,
): { readonly paint: (readout: Readout) => void; readonly dispose: () => void } {
  const reported = new Set<string>();
  const warn: HudWarn = (code, message) => {
    if (reported.has(code)) return;
    reported.add(code);
    onWarning?.(code, message);
  };
  let paints = 0;
  let isDisposed = false;
  return {
    paint(readout) {
      if (isDisposed) {
        warn('hud-disposed', 'paint was called after dispose: stop the frame loop first.');
        return;
      }
      const lacks = isRecord(readout) ? members.find((name) => !(name in readout)) : members.join(', ');
      if (lacks !== undefined) {
        warn('hud-readout', `paint was given a readout without ${lacks}: pass what ${madeBy} returns.`);
        return;
      }
      paint(readout);
      paints += 1;
      if (paints === PAINTS && onWarning !== undefined) checkSight(root, warn);
    },
    dispose() {
      if (!isDisposed) dispose();
      isDisposed = true;
    },
  };
}

const isRecord = (value: unknown): value is object => typeof value === 'object' && value !== null;

function checkSight(root: HTMLElement, warn: HudWarn): void {
  const style = root.ownerDocument.defaultView?.getComputedStyle(root);
  if (style?.getPropertyValue('--td-ink') === '')
    warn(
      'hud-unstyled',
      'hud.css is not applied: link it in the page, or in the shadow root that the HUD is in.',
    );
  if (!root.isConnected) warn('hud-detached', 'The host of the HUD is not in the page: append it.');
  else if (root.clientWidth === 0)
    warn(
      'hud-no-room',
      'The HUD is 0 px wide: give its host a width of at least 200 px, and do not hide it.',
    );
}
