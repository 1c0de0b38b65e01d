/** A document in node, for texts and attributes of HUDs and panels where nothing need be laid out. */
import { Event, parseHTML } from 'linkedom';

/** Of an element that is not laid out; the library has none of them. */
const SIZES = { clientHeight: 0, scrollHeight: 0, scrollTop: 0 };

let observer: MutationObserver;

/** Changes to the texts, attributes and elements of the newest page that `work` makes. */
export function changesBy(work: () => void): number {
  observer.takeRecords();
  work();
  return observer.takeRecords().length;
}

/** A document, and a host in it. `view` are members of its window, null for none; `members` are of every element made in it. */
export function createPage(
  view: object | null = null,
  members: object = {},
): { document: Document; root: HTMLElement } {
  const { document, MutationObserver } = parseHTML('<html><body><main></main></body></html>');
  Object.defineProperty(document, 'defaultView', { value: view });
  const maker: { createElement: (name: string) => HTMLElement } = document;
  const create = maker.createElement.bind(document);
  maker.createElement = (name) => Object.assign(create(name), SIZES, members);
  observer = new MutationObserver(() => undefined);
  observer.observe(document, { subtree: true, attributes: true, childList: true, characterData: true });
  return { document, root: Object.assign(document.querySelector('main')!, SIZES, members) };
}

/** A window in which nothing is laid out: sizes are set by the test, and `resized` tells the observers. */
export function createView({ fontSize = '16px', matches = false } = {}) {
  const observers: (() => void)[] = [];
  const media = { matches, listeners: new Set<() => void>() };
  const queries: string[] = [];
  let observed = 0;
  class ResizeObserver {
    constructor(look: () => void) {
      observers.push(look);
    }
    observe = () => (observed += 1);
    disconnect = () => (observed = 0);
  }
  const view = {
    ResizeObserver,
    getComputedStyle: () => ({ fontSize }),
    matchMedia: (query: string) => {
      queries.push(query);
      return {
        get matches() {
          return media.matches;
        },
        addEventListener: (_type: string, listener: () => void) => media.listeners.add(listener),
        removeEventListener: (_type: string, listener: () => void) => media.listeners.delete(listener),
      };
    },
  };
  return {
    view,
    media,
    queries,
    resized: () => observers.forEach((look) => look()),
    observed: () => observed,
  };
}

/** Sets what layout gives an element, px. */
export function layOut(element: Element, sizes: Partial<typeof SIZES>): void {
  Object.assign(element, sizes);
}

/** Sends the element an event with these members. */
export function fire(element: Element, type: string, members: object = {}): void {
  element.dispatchEvent(Object.assign(new Event(type), members) as unknown as globalThis.Event);
}

/** Elements with the class, or else the name, inside `root` in the order of the document. */
export function all(root: Element, name: string): HTMLElement[] {
  return [...root.querySelectorAll<HTMLElement>(`.${name}, ${name}`)];
}

/** The one such element. */
export function one(root: Element, name: string): HTMLElement {
  const found = all(root, name);
  if (found.length !== 1) throw new Error(`${String(found.length)} elements ${name}, expected one`);
  return found[0]!;
}

/** The text that is not hidden, parts separated by one space. */
export function shownText(element: Element): string {
  const texts = (node: Node): string[] => {
    if (node.nodeType === 3) return [node.textContent ?? ''];
    return (node as HTMLElement).hidden ? [] : [...node.childNodes].flatMap(texts);
  };
  return texts(element).join(' ').replace(/ +/g, ' ').trim();
}

/** Attributes by name; null for one that is not set. */
export function attributes(element: Element, ...names: string[]): (string | null)[] {
  return names.map((name) => element.getAttribute(name));
}
