/** The landing HUD in a document in node, painted with given numbers. */
import { createCockpitLandingHud, type LandingHudOptions } from '../../src/hud';
import {
  createLandingReadout,
  type Descent,
  type Drift,
  type Gates,
  type LandingReadout,
  type Righting,
  type Tilt,
  type TipMargin,
  type Touchdown,
} from '../../src/readout';
import { all, attributes, createPage, one, shownText } from './pageInNode';

type Parts = {
  descent: Partial<Descent>;
  tilt: Partial<Tilt>;
  drift: Partial<Drift>;
  gates: Partial<Gates>;
  margin: Partial<TipMargin>;
  righting: Partial<Righting>;
  touchdown: Partial<Touchdown>;
};
export type Numbers = Partial<Parts & Omit<LandingReadout, keyof Parts | 'memory'>>;

/** What is not given is as in a new readout. */
function readoutOf(numbers: Numbers): LandingReadout {
  const readout = createLandingReadout();
  for (const [name, value] of Object.entries(numbers))
    if (typeof value === 'object') Object.assign(readout[name as keyof Parts], value);
    else Object.assign(readout, { [name]: value });
  return readout;
}

/** The HUD and readers of what it shows. */
export function createLandingHud(options: LandingHudOptions = {}, view: object | null = null) {
  const { document, root } = createPage(view);
  const hud = createCockpitLandingHud(document, root, options);
  return {
    root,
    dispose: () => hud.dispose(),
    show: (numbers: Numbers) => hud.paint(readoutOf(numbers)),
    text: (name: string) => shownText(one(root, name)),
    attributes: (name: string, ...names: string[]) => attributes(one(root, name), ...names),
    parts: (name: string) => all(root, name),
  };
}
