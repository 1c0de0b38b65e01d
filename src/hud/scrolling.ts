/**
 * Makes a part that is too short for its content scroll, also by keyboard: only then does Tab stop at it. Reading heights
 * at every paint would make the browser lay the page out each time, so the sizes are watched. Returns how to stop.
 */
export function scrollWhereShort(part: HTMLElement, label: string): () => void {
  const { defaultView } = part.ownerDocument;
  if (defaultView === null) return () => undefined;
  let scrolls = false;
  const look = (): void => {
    const short = part.scrollHeight > part.clientHeight;
    if (short === scrolls) return;
    scrolls = short;
    if (short) {
      part.tabIndex = 0;
      part.setAttribute('role', 'group');
      part.setAttribute('aria-label', label);
    } else for (const name of ['tabindex', 'role', 'aria-label']) part.removeAttribute(name);
  };
  const watcher = new defaultView.ResizeObserver(look);
  watcher.observe(part);
  for (const child of part.children) watcher.observe(child);
  return () => watcher.disconnect();
}
