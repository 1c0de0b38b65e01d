/** The page in flight: its picture, keys, recordings, and what the browser keeps of it. */
import { Scene } from 'three';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { all, attributes, fire, one, shownText } from '../../hud/pageInNode';
import { type Drawn, frameOf } from '../../scene/drawn/frame';
import { useGameClock } from '../game/openGame';
import { openPage } from './openPage';

useGameClock();

let drawn: Drawn | null = null;
const { prototype } = Scene;
beforeAll(() => {
  prototype.onBeforeRender = (renderer, scene, camera) => (drawn = { renderer, scene, camera });
});
// The one of all objects is again in place.
afterAll(() => void Reflect.deleteProperty(prototype, 'onBeforeRender'));

it('shows the picture once it is drawn, with the chosen overlay and camera', async () => {
  const page = await openPage('?scenario=opening&terrain=flat&show=footprint', { hasPicture: true });
  const { dataset } = page.document.documentElement;
  const canvas = page.part('scene-view');
  const footprints = () => frameOf(drawn!).filter((line) => /scaled (\d\S*) \1 \1$/.test(line)).length;
  expect(page.text('banner')).toBe('Building the ground …');
  page.play(1, 250);
  expect([dataset['ready'], drawn === null]).toEqual([undefined, false]);
  // The server loads while the scene is created.
  expect(page.created).toEqual(['server', 'picture']);
  page.gpu.isDone = true;
  page.play(1.5, 250);
  expect([page.text('banner'), dataset['ready']]).toEqual(['', 'true']);

  const turned = new Set<string>();
  for (const words of ['behind the ship', 'from the cockpit', 'from above', 'fixed', 'around the ship']) {
    page.key('Digit3', '3');
    expect(page.text('banner')).toContain(`Camera: ${words}`);
    page.play(0.1);
    turned.add(frameOf(drawn!)[0]!);
  }
  // The ship moves little meanwhile: seen from behind it may look as from around.
  expect(turned.size).toBeGreaterThan(2);

  // A finger turns the camera.
  page.key('Digit3', '3');
  page.play(0.1);
  const before = frameOf(drawn!)[0];
  fire(canvas, 'pointerdown', { pointerId: 1, clientX: 0, clientY: 0 });
  fire(canvas, 'pointermove', { pointerId: 1, clientX: 100, clientY: 0 });
  fire(canvas, 'pointerup', { pointerId: 1 });
  page.play(0.5, 250);
  expect(frameOf(drawn!)[0]).not.toBe(before);

  // Or moves the ship.
  const button = page.button('Move the ship');
  fire(button, 'click');
  expect(attributes(button, 'aria-pressed')).toEqual(['true']);
  expect(page.text('banner')).toBe('Drag over the picture to move the ship.');
  fire(button, 'click');
  expect(attributes(button, 'aria-pressed')).toEqual(['false']);
  expect(page.text('banner')).toBe('Dragging turns the camera again.');

  fire(canvas, 'webglcontextlost');
  expect(page.text('notice')).toContain('The browser lost the 3D view.');
  fire(canvas, 'webglcontextrestored');
  expect(page.text('notice')).toBe('');
  expect(footprints()).toBeGreaterThan(0);
});

it('replays a recording by buttons and by keys, and returns to the game', async () => {
  const page = await openPage('?scenario=settle');
  const dock = page.part('dock');
  page.play(4);
  expect(page.text('dock')).toContain('Recorded 4 s');
  page.click('Replay', dock);
  await page.until(() => page.text('banner') === 'Replay');
  const deck = one(dock, 'scrubber').parentElement!.parentElement!;
  const [position] = all(deck, 'quiet');
  const place = () => shownText(position!);
  const press = (label: string) => fire(deck.querySelector(`[aria-label="${label}"]`)!, 'click');
  const disabled = () => all(dock, 'button').filter((each) => (each as HTMLButtonElement).disabled);
  expect([deck.hidden, disabled().map(shownText)]).toEqual([false, ['Replay', 'Save']]);
  page.play(1);
  expect(place()).toMatch(/^1\.\d\d \/ 4\.\d s · tick \d, substep \d+$/);
  page.click('Pause', deck);
  const paused = place();
  page.play(1);
  expect([place(), shownText(page.button('Play', deck))]).toEqual([paused, 'Play']);
  press('One substep forward');
  page.play(0.1);
  const after = place();
  expect(after).not.toBe(paused);
  press('One substep back');
  page.play(0.1);
  const back = place();
  page.key('KeyO', 'o');
  page.play(0.1);
  expect(place()).toBe(after);
  page.key('Comma', ',');
  page.play(0.1);
  expect(place()).toBe(back);
  const range = one(deck, 'input') as HTMLInputElement;
  expect(attributes(range, 'type', 'aria-label')).toEqual(['range', 'Time in the recording, seconds']);
  expect([range.step, range.max]).toEqual(['0.01', expect.stringMatching(/^(3\.9|4\.0)\d$/)]);
  fire(Object.assign(range, { valueAsNumber: 2.5 }), 'input');
  page.play(0.1);
  expect(place()).toMatch(/^2\.50 /);
  page.key('KeyP', 'p');
  page.play(0.5);
  expect(place()).toMatch(/^(2\.9|3\.0)/);
  page.click('Kick the ship');
  expect(page.text('banner')).toBe('A recording is playing: go back to the game first.');
  page.play(4.5);
  page.click('Play', deck);
  page.play(0.2);
  expect(place()).toMatch(/^0\.[12]/);
  page.click('Back to the game', deck);
  page.play(1);
  expect([page.text('banner'), deck.hidden, disabled()]).toEqual(['', true, []]);
  const received = () => /(\d+) accepted/.exec(page.text('dock'))?.[1];
  const count = received();
  page.play(3);
  expect(Number(received()) - Number(count)).toBeGreaterThan(1);
});

it('reads a file that is chosen or dropped, and explains why one cannot be played', async () => {
  const page = await openPage('?scenario=settle');
  const { body } = page.document;
  const file = (text: string) => ({ name: 'a.jsonl', size: 10, text: () => Promise.resolve(text) });
  const field = page.part('dock').querySelector('input[type=file]')!;
  fire(Object.assign(field, { files: [file('<b>')] }), 'change');
  expect(page.text('banner')).toBe('Reading a.jsonl …');
  await page.until(() => page.text('notice') !== '' && page.text('banner') === '');
  await page.until(() => page.text('notice').includes('a.jsonl cannot be played: line 1: not JSON'));
  fire(body, 'dragover');
  expect(body.classList.contains('dropping')).toBe(true);
  fire(body, 'dragleave');
  expect(body.classList.contains('dropping')).toBe(false);
  fire(body, 'dragover');
  const header = '{"touchdown":"recording"}';
  fire(body, 'drop', { dataTransfer: { files: [{ ...file(header), name: 'b.jsonl' }] } });
  expect([body.classList.contains('dropping'), page.text('banner')]).toEqual([false, 'Reading b.jsonl …']);
  await page.until(() => page.text('notice').includes('b.jsonl cannot be played'));
});

it('has keys for aids, panels, scenarios and sound', async () => {
  const page = await openPage('?scenario=settle');
  const { body } = page.document;
  page.key('Digit1', '1');
  expect(page.text('banner')).toBe('Landing aids off.');
  page.key('Digit1', '1');
  expect(page.text('banner')).toBe('Landing aids on.');
  page.key('KeyH', 'h');
  expect(body.classList.contains('bare')).toBe(true);
  page.key('KeyH', 'h');
  expect(body.classList.contains('bare')).toBe(false);
  page.key('BracketRight', ']');
  page.play(0.5);
  expect(page.query()).toBe('?scenario=bounce');
  for (let n = 0; n < 2; n++) page.key('BracketLeft', '[');
  page.play(0.5);
  expect(page.query()).toBe('?scenario=opening');
  // Node has no sound.
  page.key('Digit2', '2');
  await page.until(() => page.text('banner') === 'Sound off.');
  expect(attributes(page.button('Sound'), 'aria-pressed')).toEqual(['false']);

  page.click('Tip over, then right the ship with the key shown');
  page.play(0.5);
  expect(page.query()).toBe('?scenario=topple');
  const last = () => page.button('See the same without prediction');
  page.click('See the same without prediction');
  page.play(0.5);
  expect([page.query(), attributes(last(), 'aria-pressed')]).toEqual([
    '?scenario=topple&mode=last',
    ['true'],
  ]);
  page.click('See the same without prediction');
  page.play(0.5);
  expect([page.query(), attributes(last(), 'aria-pressed')]).toEqual(['?scenario=topple', ['false']]);
});

it('hops: full throttle for a second', async () => {
  const page = await openPage('?scenario=settle');
  page.play(4);
  const { dataset } = page.document.documentElement;
  expect(dataset['status']).toBe('landed');
  page.click('Hop: full throttle for a second, then land again');
  page.play(0.9);
  expect([page.text('flight').includes('100 %'), dataset['status']]).toEqual([true, 'flight']);
  page.play(0.2);
  expect(page.text('flight').includes('100 %')).toBe(false);
});

it('stops at the time in a link, for screenshots', async () => {
  const page = await openPage('?scenario=settle&freeze=2');
  const { dataset } = page.document.documentElement;
  page.play(1.5);
  expect([dataset['ready'], dataset['frozen']]).toEqual([undefined, undefined]);
  page.play(3);
  expect([dataset['ready'], dataset['frozen']]).toEqual(['true', 'true']);
  const shown = page.text('hud');
  page.play(3);
  expect(page.text('hud')).toBe(shown);
});

it('is stored by the browser once it is idle, and marked when complete', async () => {
  const registered: unknown[] = [];
  let complete = () => undefined as unknown;
  const serviceWorker = {
    register: (script: unknown) => Promise.resolve(registered.push(script)),
    ready: new Promise((resolve) => (complete = () => resolve(null))),
  };
  const page = await openPage('', { navigator: { serviceWorker } });
  const { dataset } = page.document.documentElement;
  page.play(2);
  expect([dataset['ready'], registered]).toEqual(['true', []]);
  page.play(5, 500);
  await page.until(() => registered.length === 1);
  await page.until(() => true);
  expect([String(registered[0]), dataset['offline']]).toEqual(['https://page.test/offline.js', undefined]);
  complete();
  await page.until(() => dataset['offline'] === 'ready');
});

it.each([
  ['on-its-side', 'HOLD S tilt towards you'],
  ['topple', 'HOLD D tilt right'],
])('names the keys that right the tipped ship of %s', async (scenario, words) => {
  const page = await openPage(`?scenario=${scenario}`);
  page.play(14, 250);
  expect(page.text('hud')).toContain(words);
});
