/**
 * Finds a Chromium for the browser tests: the one named by the environment variable CHROMIUM, an installed
 * Chromium, Chrome or Edge, else the one that @sparticuz/chromium brings through npm (linux on x64 alone).
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type * as Playwright from 'playwright-core';
import type { Browser, BrowserServer, LaunchOptions } from 'playwright-core';

/**
 * Required, not imported: before node imports a CommonJS package it parses all of it for its exports, which takes as long as loading the
 * package.
 */
const { chromium } = createRequire(import.meta.url)('playwright-core') as typeof Playwright;

/** A browser to start: its program and additional environment variables. */
export interface ChromiumProgram {
  readonly path: string;
  readonly env: Readonly<Record<string, string>>;
}

const ROOT = fileURLToPath(new URL('../..', import.meta.url));

const LINUX_NAMES = [
  'chromium-headless-shell',
  'chromium',
  'chromium-browser',
  'google-chrome-stable',
  'google-chrome',
  'microsoft-edge-stable',
  'microsoft-edge',
];
const MAC_NAMES = ['Google Chrome', 'Chromium', 'Microsoft Edge'];
const WINDOWS_PATHS = [
  'Google/Chrome/Application/chrome.exe',
  'Chromium/Application/chrome.exe',
  'Microsoft/Edge/Application/msedge.exe',
];

/** SwiftShader draws the same bits on every machine; the other flags turn off background requests. */
const ARGS = [
  '--no-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-quic',
  '--no-first-run',
];
/** Text and boxes are painted directly: through SwiftShader, which WebGL still takes, they cost several times as much. */
export const PAINT_DIRECTLY = ['--disable-gpu-rasterization', '--disable-gpu-compositing'];

function installedCandidates(): string[] {
  const env = process.env;
  if (process.platform === 'win32') {
    const folders = [env['ProgramFiles'], env['ProgramFiles(x86)'], env['LocalAppData']];
    return folders.flatMap((folder) => (folder ? WINDOWS_PATHS.map((path) => join(folder, path)) : []));
  }
  if (process.platform === 'darwin') {
    const folders = ['/Applications', join(env['HOME'] ?? '', 'Applications')];
    return folders.flatMap((folder) =>
      MAC_NAMES.map((name) => join(folder, `${name}.app/Contents/MacOS`, name)),
    );
  }
  const folders = (env['PATH'] ?? '').split(delimiter).filter((folder) => folder !== '');
  return LINUX_NAMES.flatMap((name) => folders.map((folder) => join(folder, name)));
}

/** On some systems `chromium-browser` only prints how to install one. Browsers on Windows print no version. */
function starts({ path, env }: ChromiumProgram): boolean {
  if (process.platform === 'win32') return true;
  return spawnSync(path, ['--version'], { timeout: 20_000, env: { ...process.env, ...env } }).status === 0;
}

/** Whether the system lacks a library that the program at `path` is linked with. */
function lacksLibraries(path: string): boolean {
  const ldd = spawnSync('ldd', [path], { encoding: 'utf8' });
  return ldd.status !== 0 || ldd.stdout.includes('not found');
}

/** Runs `work` with environment variables set for its duration. */
async function withEnv<T>(changes: Record<string, string>, work: () => Promise<T>): Promise<T> {
  const before = Object.keys(changes).map((key) => [key, process.env[key]] as const);
  Object.assign(process.env, changes);
  try {
    return await work();
  } finally {
    for (const [key, value] of before) {
      if (value === undefined) Reflect.deleteProperty(process.env, key);
      else process.env[key] = value;
    }
  }
}

/**
 * Unpacks the npm Chromium into `dir`. The package unpacks into os.tmpdir() and takes any files there for
 * complete, so this unpacks elsewhere and renames. With the environment of Amazon's system, the package also
 * unpacks nss, nspr and expat, for systems without them.
 */
async function unpack(dir: string): Promise<void> {
  const aside = `${dir}.${process.pid}`;
  mkdirSync(aside, { recursive: true });
  const told = {
    TMPDIR: aside,
    AWS_EXECUTION_ENV: 'AWS_Lambda_nodejs20.x',
    LD_LIBRARY_PATH: '',
    FONTCONFIG_PATH: '',
  };
  await withEnv(told, async () => {
    const { default: packed } = await import('@sparticuz/chromium');
    await packed.executablePath();
  });
  const fonts = `<?xml version="1.0"?><fontconfig><dir>${dir}/fonts</dir><cachedir>${dir}/fonts-cache</cachedir></fontconfig>`;
  writeFileSync(join(aside, 'fonts/fonts.conf'), fonts);
  renameSync(aside, dir);
}

/** The Chromium from npm, unpacked once per version, or null if it does not run. */
async function npmChromium(): Promise<ChromiumProgram | null> {
  if (process.platform !== 'linux' || process.arch !== 'x64') return null;
  const manifest = join(ROOT, 'node_modules/@sparticuz/chromium/package.json');
  if (!existsSync(manifest)) return null;
  const { version } = JSON.parse(readFileSync(manifest, 'utf8')) as { version: string };
  const dir = join(ROOT, 'node_modules/.cache/touchdown', `chromium-${version}`);
  if (!existsSync(dir)) await unpack(dir);
  const path = join(dir, 'chromium');
  const env: Record<string, string> = {};
  if (lacksLibraries(path)) env['LD_LIBRARY_PATH'] = join(dir, 'al2023/lib');
  if (!existsSync('/etc/fonts/fonts.conf')) env['FONTCONFIG_PATH'] = join(dir, 'fonts');
  const program = { path, env };
  return starts(program) ? program : null;
}

/**
 * The Chromium to test with, or null if neither the machine nor npm has one, or CHROMIUM is "none".
 * CHROMIUM=npm takes the one from npm, even if another is installed.
 * @throws if CHROMIUM names a file that does not exist
 */
export async function findChromium(): Promise<ChromiumProgram | null> {
  const wished = process.env['CHROMIUM'];
  if (wished === 'none') return null;
  if (wished === 'npm') return npmChromium();
  if (wished) {
    if (!existsSync(wished)) throw new Error(`CHROMIUM names ${wished}, which does not exist`);
    return { path: wished, env: {} };
  }
  const installed = installedCandidates().find((path) => existsSync(path) && starts({ path, env: {} }));
  return installed ? { path: installed, env: {} } : npmChromium();
}

function launchOptions(program: ChromiumProgram, args: readonly string[] = []): LaunchOptions {
  const inherited = Object.entries(process.env).filter(
    (pair): pair is [string, string] => pair[1] !== undefined,
  );
  return {
    executablePath: program.path,
    args: [...ARGS, ...args],
    env: { ...Object.fromEntries(inherited), ...program.env },
  };
}

/** Starts the browser, headless, drawing in software; `args`: further arguments of its command line. */
export function launchChromium(program: ChromiumProgram, args?: readonly string[]): Promise<Browser> {
  return chromium.launch(launchOptions(program, args));
}

/** Connects to one that serveChromium started. */
export function connectToChromium(address: string): Promise<Browser> {
  return chromium.connect(address);
}

/** Starts it for other processes, which connect to its `wsEndpoint()`. */
export function serveChromium(program: ChromiumProgram): Promise<BrowserServer> {
  return chromium.launchServer(launchOptions(program, PAINT_DIRECTLY));
}
