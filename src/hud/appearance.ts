import type { HudWarn } from './checks';

/** How a HUD looks, whatever it shows. Its container may have any width from 200 px. */
export interface HudAppearance {
  /** Colours: dark over space (default), light, or as the reader's system is set. */
  readonly theme?: 'dark' | 'light' | 'system';
  /** Full height, about half of it, or (default) compact where the window is at most 520 px wide. */
  readonly layout?: 'auto' | 'full' | 'compact';
  /** Called once per mistake that keeps the HUD from being seen: no style sheet, no room, calls after dispose. */
  readonly onWarning?: HudWarn;
}

const SMALL_WINDOW = '(max-width: 32.5em)';

/** A HUD's outermost element with its panel; the sheets read its attributes. */
export interface HudFrame {
  readonly root: HTMLElement;
  /** Holds everything that is shown; the root is the container whose width the style sheets query. */
  readonly panel: HTMLElement;
  readonly dispose: () => void;
}

/** Makes the frame of one HUD; the caller puts `root` into its host once it is filled. */
export function createFrame(
  document: Document,
  kind: 'landing' | 'fleet' | 'flight',
  label: string,
  { theme = 'dark', layout = 'auto' }: HudAppearance,
): HudFrame {
  const root = document.createElement('section');
  root.className = `td-hud td-${kind}`;
  root.setAttribute('aria-label', label);
  root.setAttribute('data-theme', theme);
  const panel = document.createElement('div');
  panel.className = 'td-panel';
  root.append(panel);
  const small = layout === 'auto' ? document.defaultView?.matchMedia(SMALL_WINDOW) : undefined;
  const lay = (): void => {
    const compact = layout === 'compact' || small?.matches === true;
    root.setAttribute('data-layout', compact ? 'compact' : 'full');
  };
  lay();
  small?.addEventListener('change', lay);
  return {
    root,
    panel,
    dispose: () => {
      small?.removeEventListener('change', lay);
      root.remove();
    },
  };
}
