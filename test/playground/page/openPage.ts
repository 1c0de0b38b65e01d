/** The whole page in node, on a virtual clock: its own HTML, the real server, and a renderer that only counts. */
import { readFileSync } from 'node:fs';
import { setImmediate } from 'node:timers';
import { parseHTML } from 'linkedom';
import { expect, vi } from 'vitest';
import { begin } from '../../../src/playground/page';
import { fire, shownText } from '../../hud/pageInNode';
import { createCountedCanvas } from '../../scene/drawn/context';
import { serveInNode } from '../game/openGame';

const HTML = readFileSync('src/playground/index.html', 'utf8');

/** What linkedom lacks of an element that is not laid out. */
const MEMBERS = {
  ...{ clientWidth: 800, clientHeight: 600, scrollHeight: 0, scrollTop: 0 },
  ...{ focus: () => undefined, select: () => undefined, setPointerCapture: () => undefined },
  showModal(this: HTMLDialogElement) {
    this.open = true;
  },
  close(this: HTMLDialogElement) {
    this.open = false;
  },
};
const PEN = { clearRect: () => undefined, fillRect: () => undefined, fillStyle: '' };

export interface OpenPage {
  readonly document: Document;
  readonly part: (id: string) => HTMLElement;
  /** The text that is shown in a part. */
  readonly text: (id: string) => string;
  /** Draws a picture every `step` ms for so many seconds. */
  readonly play: (seconds: number, step?: number) => void;
  /** Lets code that is loaded on demand come, until the condition holds. */
  readonly until: (holds: () => unknown) => Promise<void>;
  readonly key: (code: string, key?: string) => void;
  /** A button of the panel, or in another element. */
  readonly button: (text: string, within?: Element) => HTMLButtonElement;
  readonly click: (text: string, within?: Element) => void;
  readonly field: (label: string) => HTMLSelectElement;
  /** Changes a field; the text of its complaint. */
  readonly choose: (label: string, value: string) => string;
  /** The query in the address. */
  readonly query: () => string;
  readonly copied: string[];
  /** The servers and pictures that were created, in order. */
  readonly created: readonly ('server' | 'picture')[];
  /** Whether the picture's commands are carried out. */
  readonly gpu: { isDone: boolean };
}

interface Wishes {
  /** More of the window's navigator. */
  readonly navigator?: object;
  readonly stored?: Readonly<Record<string, string>>;
  /** Without WebGL there is no picture, and everything else. */
  readonly hasPicture?: boolean;
}

async function until(holds: () => unknown): Promise<void> {
  for (let tries = 0; !holds(); tries++) {
    if (tries > 20_000) throw new Error(`never: ${String(holds)}`);
    await new Promise((resolve) => setImmediate(resolve));
  }
}

function createStore(stored: Readonly<Record<string, string>>) {
  const kept = new Map(Object.entries(stored));
  return {
    getItem: (name: string) => kept.get(name) ?? null,
    setItem: (name: string, value: string) => void kept.set(name, value),
    removeItem: (name: string) => void kept.delete(name),
  };
}

/** Call within useGameClock. Waits for the workshop's code, where the page begins with it. */
export async function openPage(
  search: string,
  { navigator = {}, stored = {}, hasPicture = false }: Wishes = {},
): Promise<OpenPage> {
  const { document, Element, HTMLElement } = parseHTML(HTML);
  const copied: string[] = [];
  const created: ('server' | 'picture')[] = [];
  let frames: ((milliseconds: number) => void)[] = [];
  const location = { search, pathname: '/', origin: 'https://page.test' };
  const members = {
    document,
    location,
    history: { replaceState: (_state: unknown, _title: string, to: string) => void (location.search = to) },
    navigator: {
      getGamepads: () => [],
      clipboard: { writeText: (text: string) => Promise.resolve(void copied.push(text)) },
      ...navigator,
    },
    localStorage: createStore(stored),
    devicePixelRatio: 2,
    matchMedia: () => ({ matches: false, addEventListener: () => undefined }),
    getComputedStyle: () => ({ fontSize: '16px' }),
    ResizeObserver: class {
      observe = () => undefined;
      disconnect = () => undefined;
    },
    requestAnimationFrame: (draw: (milliseconds: number) => void) => frames.push(draw),
  };
  const window = Object.assign(new EventTarget(), members);
  Object.defineProperty(document, 'defaultView', { value: window });
  Object.defineProperty(document, 'baseURI', { value: `${location.origin}/` });
  vi.stubGlobal('document', document);
  vi.stubGlobal('Element', Element);
  vi.stubGlobal('HTMLElement', HTMLElement);
  vi.stubGlobal('ResizeObserver', members.ResizeObserver);
  vi.stubGlobal('getComputedStyle', () => ({ color: '#fff' }));
  vi.stubGlobal('navigator', members.navigator);
  vi.stubGlobal('Option', function (text: string, value: string) {
    return Object.assign(document.createElement('option'), { textContent: text, value });
  });
  const { canvas, gpu } = createCountedCanvas();
  const maker: { createElement: (name: string) => HTMLElement } = document;
  const create = maker.createElement.bind(document);
  maker.createElement = (name) => {
    const element = Object.assign(create(name), MEMBERS);
    if (name === 'select') {
      Object.defineProperty(element, 'value', { value: '', writable: true });
      Object.assign(element, { add: (option: Element) => element.append(option) });
    }
    return name === 'canvas'
      ? Object.assign(element, { getContext: (kind: string) => (kind === '2d' ? PEN : null) })
      : element;
  };
  const part = (id: string) => document.getElementById(id)!;
  for (const element of document.querySelectorAll('*')) Object.assign(element, MEMBERS);
  Object.assign(part('scene-view'), {
    getContext(kind: string) {
      created.push('picture');
      return hasPicture ? canvas.getContext(kind as 'webgl2') : null;
    },
    ...{ width: 300, height: 150 },
  });
  serveInNode();
  const { Worker: InNode } = globalThis;
  vi.stubGlobal('Worker', function (...given: ConstructorParameters<typeof Worker>) {
    created.push('server');
    return new InNode(...given);
  });
  begin(document, 'main.js');
  if (document.body.classList.contains('workshop'))
    await until(() => document.querySelector('#panel .run') && document.querySelector('#dock canvas'));

  const button = (text: string, within: Element = part('panel')) => {
    const found = [...within.querySelectorAll('button')].filter((each) => shownText(each) === text);
    expect(found, text).toHaveLength(1);
    return found[0]!;
  };
  const field = (label: string) => {
    const found = [...document.querySelectorAll('label')].filter((each) => shownText(each) === label);
    expect(found, label).toHaveLength(1);
    return part(found[0]!.htmlFor) as HTMLSelectElement;
  };
  return {
    document,
    part,
    copied,
    created,
    gpu,
    button,
    field,
    text: (id) => shownText(part(id)),
    query: () => location.search,
    play(seconds, step = 100) {
      for (let passed = 0; passed < seconds * 1000; passed += step) {
        vi.advanceTimersByTime(step);
        const due = frames;
        frames = [];
        for (const draw of due) draw(performance.now());
      }
    },
    until,
    key(code, key = code.replace('Key', '').toLowerCase()) {
      const members = { code, key, getModifierState: () => false };
      for (const type of ['keydown', 'keyup'])
        window.dispatchEvent(Object.assign(new Event(type, { cancelable: true }), members));
    },
    click: (text, within) => fire(button(text, within), 'click'),
    choose(label, value) {
      const control = field(label);
      control.value = value;
      fire(control, 'change');
      return shownText(part(`${control.id}-wrong`));
    },
  };
}

/** A page on a demonstration, which begins with the workshop open. */
export const openWorkshop = async (query = '?scenario=settle') => {
  const page = await openPage(query);
  page.play(0.5);
  return page;
};
