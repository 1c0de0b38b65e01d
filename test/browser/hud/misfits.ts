/** Finds parts of the HUDs that do not fit on a page, in a real browser. */
import type { Page } from 'playwright-core';

/** Texts that are clipped, overflow their panel, the window or an ancestor that clips, or overlap another text. */
export function misfits(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const out: string[] = [];
    const texts: { readonly text: string; readonly ink: DOMRect; readonly element: Element }[] = [];
    const say = (fault: string, element: Element, text = element.textContent) =>
      out.push(`${fault}: .${element.getAttribute('class') ?? ''} ${text.slice(0, 40)}`);
    const within = (box: DOMRect, room: DOMRect) =>
      box.left >= room.left - 0.5 &&
      box.right <= room.right + 0.5 &&
      box.top >= room.top - 0.5 &&
      box.bottom <= room.bottom + 0.5;
    const clips = (element: Element) => {
      const { display, overflowX, overflowY, contain } = getComputedStyle(element);
      if (display === 'contents') return false;
      return overflowX !== 'visible' || overflowY !== 'visible' || contain !== 'none';
    };
    const isCut = (box: DOMRect, element: Element, panel: Element) => {
      for (let up: Element | null = element; up !== null && up !== panel.parentElement; up = up.parentElement)
        if ((up === panel || clips(up)) && !within(box, up.getBoundingClientRect())) return true;
      return false;
    };
    /** The box of the letters: line boxes have the font's height, and neighbouring ones may overlap. */
    const inkOf = (line: DOMRect, element: Element) => {
      const size = parseFloat(getComputedStyle(element).fontSize);
      return new DOMRect(line.left, line.top + line.height / 2 - 0.36 * size, line.width, 0.72 * size);
    };

    const root = document.documentElement;
    // On a small screen the page itself scrolls, but only vertically.
    const room = new DOMRect(0, -scrollY, innerWidth, Math.max(innerHeight, root.scrollHeight));
    if (root.scrollWidth > innerWidth) say('scrolls sideways', root, '');
    for (const panel of document.querySelectorAll('.td-hud')) {
      if (!within(panel.getBoundingClientRect(), room)) say('outside the window', panel, '');
      for (const element of panel.querySelectorAll<HTMLElement | SVGElement>('*')) {
        if (element.closest('.td-unseen, .td-rows, .td-shape, .td-tick, .td-arrow') !== null) continue;
        if (!element.checkVisibility({ visibilityProperty: true })) continue;
        const box = element.getBoundingClientRect();
        if (element.children.length === 0 && isCut(box, element.parentElement!, panel)) say('cut', element);
        if (clips(element) && !element.classList.contains('td-scroller')) {
          if (element.scrollWidth > element.clientWidth + 1) say('wider than its room', element);
          if (element.scrollHeight > element.clientHeight + 1) say('higher than its room', element);
        }
        for (const node of element.childNodes) {
          const text = node.nodeType === Node.TEXT_NODE ? node.textContent!.trim() : '';
          if (text === '') continue;
          const range = document.createRange();
          range.selectNodeContents(node);
          for (const line of range.getClientRects()) {
            const ink = inkOf(line, element);
            texts.push({ text, ink, element });
            if (isCut(ink, element, panel)) say('cut', element);
          }
        }
      }
    }
    texts.forEach((a, i) => {
      for (const b of texts.slice(i + 1)) {
        const across = Math.min(a.ink.right, b.ink.right) - Math.max(a.ink.left, b.ink.left);
        const down = Math.min(a.ink.bottom, b.ink.bottom) - Math.max(a.ink.top, b.ink.top);
        if (across > 0.5 && down > 0.5) out.push(`one over the other: ${a.text} and ${b.text}`);
      }
    });
    const [first, second] = [...document.querySelectorAll('.td-hud')].map((hud) =>
      hud.getBoundingClientRect(),
    );
    if (first !== undefined && second !== undefined && second.top < first.bottom)
      out.push('the fleet lies over the landing HUD');
    return [...new Set(out)];
  });
}
