/** A document in node with the members that HUDs and panels use: their texts and attributes can be read where nothing is laid out. */

class PageElement {
  readonly childNodes: (PageElement | PageText)[] = [];
  readonly style: Record<string, string> = {};
  readonly attributes: Record<string, string> = {};
  readonly listeners: Record<string, ((event: object) => void)[]> = {};
  readonly nodeType = 1;
  parent: PageElement | null = null;
  private isHidden = false;
  clientHeight = 0;
  scrollHeight = 0;
  scrollTop = 0;

  constructor(
    readonly ownerDocument: Document,
    readonly localName: string,
  ) {}

  get hidden(): boolean {
    return this.isHidden;
  }
  set hidden(hidden: boolean) {
    changes += 1;
    this.isHidden = hidden;
  }
  get children(): PageElement[] {
    return this.childNodes.filter((node) => node instanceof PageElement);
  }
  get lastElementChild(): PageElement | undefined {
    return this.children.at(-1);
  }
  get className(): string {
    return this.attributes['class'] ?? '';
  }
  set className(names: string) {
    this.attributes['class'] = names;
  }
  set tabIndex(index: number) {
    this.attributes['tabindex'] = String(index);
  }
  get textContent(): string {
    return this.childNodes.map((node) => (node instanceof PageText ? node.data : node.textContent)).join('');
  }
  set textContent(text: string) {
    changes += 1;
    this.childNodes.splice(0, Infinity, new PageText(text));
  }
  append(...given: (PageElement | PageText | string)[]): void {
    changes += 1;
    const nodes = given.map((node) => (typeof node === 'string' ? new PageText(node) : node));
    for (const node of nodes) node.parent = this;
    this.childNodes.push(...nodes);
  }
  replaceChildren(): void {
    changes += 1;
    this.childNodes.length = 0;
  }
  remove(): void {
    this.parent?.childNodes.splice(this.parent.childNodes.indexOf(this), 1);
  }
  setAttribute(name: string, value: unknown): void {
    changes += 1;
    this.attributes[name] = String(value);
  }
  removeAttribute(name: string): void {
    Reflect.deleteProperty(this.attributes, name);
  }
  addEventListener(type: string, listener: (event: object) => void): void {
    (this.listeners[type] ??= []).push(listener);
  }
}

class PageText {
  parent: PageElement | null = null;
  constructor(private text: string) {}
  get data(): string {
    return this.text;
  }
  set data(text: string) {
    changes += 1;
    this.text = text;
  }
}

export type { PageElement };

/** Texts, attributes and elements that were set, added or hidden so far. */
let changes = 0;

/** How many of these `work` does. */
export function changesBy(work: () => void): number {
  const before = changes;
  work();
  return changes - before;
}

/** A document, and a host in it. `view` are members of its window, null for none; `members` are of every element beside those above. */
export function createPage(
  view: object | null = null,
  members: object = {},
): { document: Document; host: HTMLElement; root: PageElement } {
  const page = { defaultView: view } as unknown as Document;
  const create = (name: string) => Object.assign(new PageElement(page, name), members);
  Object.assign(page, {
    createElement: create,
    createElementNS: (_space: string, name: string) => create(name),
    createTextNode: (text: string) => new PageText(text),
    documentElement: create('html'),
  });
  const root = create('main');
  return { document: page, host: root as unknown as HTMLElement, root };
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

/** Elements with the class, or else the name, inside `root` in the order of the document. */
export function all(root: PageElement, name: string): PageElement[] {
  const isMeant = ({ className, localName }: PageElement) =>
    localName === name || className.split(' ').includes(name);
  return root.children.flatMap((child) => [...(isMeant(child) ? [child] : []), ...all(child, name)]);
}

/** The one such element. */
export function one(root: PageElement, name: string): PageElement {
  const found = all(root, name);
  if (found.length !== 1) throw new Error(`${String(found.length)} elements ${name}, expected one`);
  return found[0]!;
}

/** The text that is not hidden, parts separated by one space. */
export function shownText(element: PageElement): string {
  const texts = (node: PageElement | PageText): string[] => {
    if (node instanceof PageText) return [node.data];
    return node.hidden ? [] : node.childNodes.flatMap(texts);
  };
  return texts(element).join(' ').replace(/ +/g, ' ').trim();
}

/** Attributes by name; null for one that is not set. */
export function attributes(element: PageElement, ...names: string[]): (string | null)[] {
  return names.map((name) => element.attributes[name] ?? null);
}
