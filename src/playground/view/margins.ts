import type { SceneView } from '../../scene';

/** The elements over the picture, by ID. */
type Part = (id: string) => HTMLElement;

/** Share of the picture's height that the ship needs: a card that leaves less lies over it. */
const ROOM = 0.2;

/** What panels cover of the picture's middle, CSS pixels. The advice below the goal comes and goes: the picture does not follow it. */
export function coveredBy(window: Window, part: Part): { readonly top: number; readonly bottom: number } {
  const picture = part('picture').getBoundingClientRect();
  const middle = (picture.left + picture.right) / 2;
  const rectOf = (element: Element | null) => {
    const rect = element?.getBoundingClientRect();
    return rect !== undefined && rect.left < middle && rect.right > middle ? rect : null;
  };
  const foot = part('foot');
  // In a narrow window the instruments scroll below the picture.
  const isOver = window.getComputedStyle(foot).position === 'absolute';
  const lowest = [isOver ? foot : null, part('pads').querySelector('.thumb-middle')].map(
    (element) => rectOf(element)?.top ?? picture.bottom,
  );
  const bottom = Math.max(0, picture.bottom - Math.min(...lowest));
  const goal = part('goal');
  // After the end the goal has no keys.
  const goalRect = rectOf(goal.querySelector('.goal-how')) ?? rectOf(goal.querySelector('.goal-words'));
  const [overGoal, overCard] = [goalRect, rectOf(part('card'))].map((rect) =>
    Math.max(0, (rect?.bottom ?? picture.top) - picture.top),
  ) as [number, number];
  const height = picture.bottom - picture.top;
  const top = height - bottom - overCard >= ROOM * height ? Math.max(overGoal, overCard) : overGoal;
  return { top, bottom };
}

/** Keeps the ship between the panels over the picture, and the score card above those at its lower edge. */
export function watchMargins(window: Window & typeof globalThis, part: Part, sceneView: SceneView): void {
  const observer = new window.ResizeObserver(() => {
    const { top, bottom } = coveredBy(window, part);
    sceneView.setMargins(top, bottom);
    part('top').style.setProperty('--below', `${bottom}px`);
  });
  for (const id of ['picture', 'goal', 'card', 'foot', 'flight', 'pads']) observer.observe(part(id));
}
