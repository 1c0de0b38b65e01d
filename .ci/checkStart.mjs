// Runs `npm start` like a newcomer, waits for the address that it prints, and requests the page and its script.
//   node .ci/checkStart.mjs              npm start
//   node .ci/checkStart.mjs run example  npm run example
import { spawn } from 'node:child_process';

const WAIT_MS = 180_000;
const COMMAND = process.argv.length > 2 ? process.argv.slice(2) : ['start'];
const NAME = `npm ${COMMAND.join(' ')}`;
/** As a browser requests a style sheet; otherwise the development server answers with a script. */
const CSS = { headers: { accept: 'text/css' } };

const child = spawn('npm', [...COMMAND, '--', '--host', '127.0.0.1'], {
  stdio: ['ignore', 'pipe', 'inherit'],
  detached: true,
  shell: process.platform === 'win32',
});

function stop(code, message) {
  console.log(message);
  try {
    process.kill(process.platform === 'win32' ? child.pid : -child.pid);
  } catch {
    // It has already exited.
  }
  process.exit(code);
}

async function check(address) {
  const page = await fetch(address);
  const html = await page.text();
  const script = /<script type="module" src="([^"]+)"/g;
  const scripts = [...html.matchAll(script)].map((match) => new URL(match[1], address).href);
  if (page.status !== 200 || scripts.length === 0) stop(1, `${NAME}: ${address} returned no page`);
  for (const url of scripts) {
    const { status, headers } = await fetch(url);
    const type = headers.get('content-type') ?? '';
    if (status !== 200 || !type.includes('javascript')) stop(1, `${NAME}: ${url} returned ${status} ${type}`);
  }
  const sheets = [...html.matchAll(/<link rel="stylesheet" href="([^"]+)"/g)];
  const styles = await Promise.all(
    sheets.map(async ([, href]) => (await fetch(new URL(href, address), CSS)).text()),
  );
  if (sheets.length > 0 && !styles.some((text) => text.includes('.td-hud')))
    stop(1, `${NAME}: no style sheet of ${address} contains that of the HUDs`);
  stop(0, `${NAME}: serves ${scripts.length} scripts and the page`);
}

setTimeout(() => stop(1, `${NAME}: no address within ${WAIT_MS / 1000} s`), WAIT_MS);
child.on('exit', (code) => stop(1, `${NAME}: ended with ${code}`));
let printed = '';
child.stdout.setEncoding('utf8').on('data', (text) => {
  process.stdout.write(text);
  const known = printed.length;
  printed += text;
  // vite prints the port in colour.
  const address = (t) => /http:\/\/[\d.]+:\d+\//.exec(t.replace(/\u001b\[[\d;]*m/g, ''))?.[0];
  if (address(printed) && !address(printed.slice(0, known))) {
    check(address(printed)).catch((error) => stop(1, `${NAME}: ${error.message}`));
  }
});
