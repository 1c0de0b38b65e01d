/** Paints one readout after the other; holds DOM until disposed. */
export interface Hud<Readout> {
  /** Touches the DOM only where what is shown changed. */
  readonly paint: (readout: Readout) => void;
  /** Takes everything out of the host again. */
  readonly dispose: () => void;
}
