import { FLEET_ORDER, type FleetReadout, STATUS_LOOKS, type StatusId } from '../../readout';
import { createFrame, type HudAppearance } from '../appearance';
import { checked, requireHost } from '../checks';
import { append } from '../elements';
import { createFleetRow, type FleetRowElement } from './fleetRow';
import type { Hud } from '../hud';
import { showPart, showText } from '../shown';

/** rem; fleet.css gives the rows this height. */
const ROW_HEIGHT = 1.75;
/** Most rows in the DOM, however tall the list is. */
const MAX_ROWS = 30;

/**
 * Creates the fleet HUD and appends it to `host`, which may be a shadow root: one row per ship, those that need help first,
 * counts in the header (HUD, Fleet). Only the rows in sight exist, so that 1,000 ships scroll as smoothly as ten.
 *
 * @example
 * ```ts
 * const hud = createFleetHud(document, host);
 * hud.paint(updateFleetReadout(createFleetReadout(), predictor.view(now)));
 * ```
 */
export function createFleetHud(
  document: Document,
  host: Element | ShadowRoot,
  options: HudAppearance = {},
): Hud<FleetReadout> {
  requireHost(document, host, options);
  const { root, panel, dispose } = createFrame(document, 'fleet', 'Fleet', options);
  const header = append(panel, 'header', 'td-fleet-header');
  append(header, 'h2', '', 'Fleet');
  const paintCounts = createCounts(header);
  const scroller = append(panel, 'div', 'td-scroller');
  scroller.tabIndex = 0;
  scroller.setAttribute('role', 'region');
  scroller.setAttribute('aria-label', 'Ships');
  const list = append(scroller, 'ul', 'td-rows');
  const rows: FleetRowElement[] = [];
  let newest: FleetReadout | null = null;
  let length = NaN;
  let sight = 0;
  /** px */
  let rowHeight = 28;
  let scrolled = 0;

  function paintRows(readout: FleetReadout): void {
    if (readout.count !== length) {
      length = readout.count;
      list.style.height = `${String(length * ROW_HEIGHT)}rem`;
    }
    const wanted = Math.min(MAX_ROWS, Math.ceil(sight / rowHeight) + 1, length);
    const first = Math.max(0, Math.min(Math.floor(scrolled / rowHeight), length - wanted));
    while (rows.length < wanted) rows.push(createFleetRow(list, ROW_HEIGHT));
    while (rows.length > wanted) rows.pop()!.element.remove();
    for (let i = 0; i < wanted; i++) rows[i]!.paint(readout.rows[first + i]!, first + i, length);
  }

  function look(): void {
    sight = scroller.clientHeight;
    rowHeight = ROW_HEIGHT * rootFontSize(document);
    scrolled = scroller.scrollTop;
    if (newest !== null) paintRows(newest);
  }

  host.append(root);
  scroller.addEventListener('scroll', look, { passive: true });
  // Reading the height at every paint would force a layout each time.
  const watcher = document.defaultView === null ? null : new document.defaultView.ResizeObserver(look);
  watcher?.observe(scroller);
  const hud = {
    ...({ root, members: ['rows', 'counts'], madeBy: 'updateFleetReadout' } as const),
    paint: (readout: FleetReadout) => {
      newest = readout;
      paintCounts(readout);
      paintRows(readout);
    },
    dispose: () => {
      watcher?.disconnect();
      dispose();
    },
  };
  return checked(hud, options.onWarning);
}

/** px of a rem; browsers' default where the document is not displayed. */
function rootFontSize(document: Document): number {
  return parseFloat(document.defaultView?.getComputedStyle(document.documentElement).fontSize ?? '') || 16;
}

/** `2 tipped`, `1 in contact`, …: only statuses that some ship has. */
function createCounts(header: Element): (readout: FleetReadout) => void {
  const paints = FLEET_ORDER.map((status) => createCount(header, status));
  return ({ counts }) => {
    FLEET_ORDER.forEach((status, i) => paints[i]!(counts[status]));
  };
}

/** After a number, where that is not the status itself. */
const COUNTED: Partial<Record<StatusId, string>> = {
  flight: 'in flight',
  contact: 'in contact',
  none: 'without data',
};

function createCount(header: Element, status: StatusId): (count: number) => void {
  const part = append(header, 'span', 'td-count');
  part.setAttribute('data-colour', STATUS_LOOKS[status].colour);
  const paintText = showText(part);
  const paintShown = showPart(part);
  const word = COUNTED[status] ?? status;
  let shown = NaN;
  return (count) => {
    if (count === shown) return;
    shown = count;
    paintShown(count > 0);
    paintText(`${String(count)} ${word}`);
  };
}
