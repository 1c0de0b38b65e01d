import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { createBanner } from '../../../src/playground/panels/banner';

/** The members of an element that a banner uses. */
function createBannerOnly() {
  const attributes: Record<string, string> = {};
  const setAttribute = (name: string, value: string) => void (attributes[name] = value);
  const element = { textContent: '', attributes, setAttribute };
  return { element, banner: createBanner(element as unknown as HTMLElement) };
}

describe('the banner', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('shows an action for four seconds over the state, then the state again', () => {
    const { element, banner } = createBannerOnly();
    banner.state('Paused');
    banner.flash('Link copied');
    expect(element.textContent).toBe('Link copied');
    vi.advanceTimersByTime(3900);
    expect(element.textContent).toBe('Link copied');
    vi.advanceTimersByTime(200);
    expect(element.textContent).toBe('Paused');
  });

  it('gives each action its full time, and keeps a state that changes meanwhile', () => {
    const { element, banner } = createBannerOnly();
    banner.flash('Sound on.');
    vi.advanceTimersByTime(3000);
    banner.flash('Sound off.');
    banner.state('Paused');
    vi.advanceTimersByTime(3000);
    expect(element.textContent).toBe('Sound off.');
    vi.advanceTimersByTime(1100);
    expect(element.textContent).toBe('Paused');
    banner.state('');
    expect(element.textContent).toBe('');
  });

  it('shows a lasting text only while there is nothing else', () => {
    const { element, banner } = createBannerOnly();
    banner.rest('Building the ground …');
    banner.state('Connection lost');
    expect(element.textContent).toBe('Connection lost');
    banner.state('');
    expect(element.textContent).toBe('Building the ground …');
  });

  it('announces a countdown once, and what follows it', () => {
    const { element, banner } = createBannerOnly();
    const announced = (text: string) => {
      banner.state(text);
      return element.attributes['aria-live'];
    };
    const texts = ['Lost. Retrying in 10 s.', 'Lost. Retrying in 9 s.', 'Reconnecting…', 'Connected again.'];
    expect(texts.map(announced)).toEqual(['polite', 'off', 'polite', 'polite']);
  });
});
