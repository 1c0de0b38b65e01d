import { OVERLAY_COLOURS } from '../../scene';
import type { OverlayName } from './choices';
import { append } from './elements';

/** The meaning of each colour over the picture: colour as 0xrrggbb, and words. */
const LEGEND: Readonly<Record<OverlayName, readonly (readonly [number, string])[]>> = {
  ghost: [[OVERLAY_COLOURS.ghost, 'Hull: newest server state']],
  errorSegment: [[OVERLAY_COLOURS.error, 'Line: from the drawn to the predicted ship']],
  contactNormal: [[OVERLAY_COLOURS.normal, 'Arrow: ground normal under the ship']],
  footprint: [[OVERLAY_COLOURS.footprint, 'Ring: footprint of the legs']],
  forces: [
    [OVERLAY_COLOURS.thrust, 'Arrow: thrust'],
    [OVERLAY_COLOURS.weight, 'Arrow: weight'],
    [OVERLAY_COLOURS.support, 'Arrow: ground force'],
  ],
};

/** Shows the legend of the overlays that are on. */
export function createOverlayLegend(host: Element): (shown: readonly OverlayName[]) => void {
  const list = append(host, 'ul', 'overlay-legend');
  return (shown) => {
    list.replaceChildren();
    list.hidden = shown.length === 0;
    for (const [colour, words] of shown.flatMap((name) => LEGEND[name])) {
      const row = append(list, 'li');
      const swatch = append(row, 'span', 'swatch');
      swatch.style.setProperty('background', `#${colour.toString(16).padStart(6, '0')}`);
      append(row, 'span', '', words);
    }
  };
}
