import { DISTANCE, type FleetRow, STATUS_LOOKS } from '../../readout';
import { append } from '../elements';
import { showAttribute, showNumber, showText } from '../shown';

/** One of the few row elements; it shows another ship each time the list scrolls. */
export interface FleetRowElement {
  readonly element: HTMLLIElement;
  readonly paint: (row: FleetRow, index: number, count: number) => void;
}

const PROVENANCE_WORDS = { confirmed: 'CONF', predicted: 'PRED', stale: 'STALE', off: 'PRED OFF' } as const;

export function createFleetRow(list: Element, height: number): FleetRowElement {
  const element = append(list, 'li', 'td-row');
  const shape = append(element, 'span', 'td-shape');
  shape.setAttribute('aria-hidden', 'true');
  const paintShape = showText(shape);
  const paintWord = showText(append(element, 'strong', 'td-word'));
  const paintName = showText(append(element, 'span', 'td-name'));
  const paintHeight = showNumber(append(element, 'span', 'td-height'), DISTANCE);
  const paintProvenance = showText(append(element, 'span', 'td-provenance'));
  const paintColour = showAttribute(element, 'data-colour');
  const paintKind = showAttribute(element, 'data-provenance');
  const paintOwn = showAttribute(element, 'data-own');
  const paintPosition = showAttribute(element, 'aria-posinset');
  const paintSize = showAttribute(element, 'aria-setsize');
  let at = NaN;
  let size = NaN;
  return {
    element,
    paint: (row, index, count) => {
      if (index !== at) {
        at = index;
        element.style.transform = `translateY(${String(index * height)}rem)`;
        paintPosition(String(index + 1));
      }
      if (count !== size) {
        size = count;
        paintSize(String(count));
      }
      const look = STATUS_LOOKS[row.status];
      paintShape(look.shape);
      paintWord(look.word);
      paintColour(look.colour);
      paintName(row.name);
      paintHeight(row.height);
      paintKind(row.provenance);
      paintProvenance(row.withdrawn === '' ? PROVENANCE_WORDS[row.provenance] : 'WITHDRAWN');
      paintOwn(row.own ? 'true' : 'false');
    },
  };
}
