/** The example client in a real browser, against a server that speaks the game's JSON. */
import { PNG } from 'pngjs';
import { createServer, type ViteDevServer } from 'vite';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { type GameServer, startGameServer } from '../example/gameServer';
import { describeInBrowser, openUrl, problemsOf } from './pages';

/** Pixels of the ghost's colour, 0x7fe4ff: it is drawn around the ship, not elsewhere on the Moon. */
function cyanIn(picture: Buffer): number {
  const { data } = PNG.sync.read(picture);
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    if (Math.abs(data[i]! - 0x7f) < 40 && data[i + 1]! > 180 && data[i + 2]! > 220) count += 1;
  return count;
}

let game: GameServer;
let host: ViteDevServer;

describeInBrowser('the example client', () => {
  beforeAll(async () => {
    game = await startGameServer('settle', 10);
    const configFile = 'src/example/vite.config.mjs';
    host = await createServer({
      configFile,
      logLevel: 'error',
      server: { host: '127.0.0.1', port: 0, hmr: false },
    });
    await host.listen();
  });
  afterAll(async () => {
    await host.close();
    await game.close();
  });

  it('signs in, draws the ship until it has landed, and sends the pilot’s controls', async () => {
    const address = `${host.resolvedUrls!.local[0]!}?server=${game.address}&user=ada&password=x`;
    const page = await openUrl(address, { framesPerSecond: 4 });
    const warnings: string[] = [];
    page.on('console', (message) => {
      // On a busy machine frames are rare, and the predictor rightly warns of it.
      const isOfMachine = /GPU|GL Driver|WebGL|^advance-seldom/.test(message.text());
      if (message.type() === 'warning' && !isOfMachine) warnings.push(message.text());
    });
    await expect.poll(() => page.textContent('.td-landing .td-status')).toMatch(/LANDED/);
    expect(await page.textContent('.td-fleet')).toContain('Kestrel');
    // The HUDs have that colour too.
    const style = '#landing, #fleet, #link { visibility: hidden }';
    expect(cyanIn(await page.locator('#scene').screenshot({ style }))).toBeGreaterThan(20);
    expect(game.controls).toEqual([]);
    await page.keyboard.press('f');
    await expect.poll(() => game.controls.at(-1)?.thrustLevel).toBeCloseTo(0.1);
    await page.keyboard.down('w');
    await expect.poll(() => game.controls.at(-1)?.rotationInput).toEqual([-1, 0, 0]);
    await page.keyboard.up('w');
    await expect.poll(() => game.controls.at(-1)?.rotationInput).toEqual([0, 0, 0]);
    expect(warnings).toEqual([]);
    expect(problemsOf(page)).toEqual([]);
  });
});
