// A headless browser and pages in it that note what must not be: requests, errors.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { samplePage } from './sample_page.mjs';

const { G31_PAGE_BUNDLE, G31_PAGE_PACKAGES, G31_CHROMIUM, G31_PROGRAM } = process.env;
const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const packages = createRequire(path.join(path.resolve(G31_PAGE_PACKAGES), 'package.json'));

const { chromium } = packages('playwright-core');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'g31-page-'));
process.on('exit', () => fs.rmSync(folder, { recursive: true, force: true }));

/** A browser that draws WebGL without a graphics card, and all else of a page without going through it. */
export const launch = () => chromium.launch({
  executablePath: G31_CHROMIUM,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
    '--disable-gpu-compositing'],
});

/** A sample run as a page on the disk; its place. */
export function pageOf(name, run) {
  const file = path.join(folder, `${name}.html`);
  fs.writeFileSync(file, samplePage(run, G31_PAGE_BUNDLE));
  return file;
}

const writesPages = () => spawnSync(G31_PROGRAM, ['run', '--help'], { encoding: 'utf8' }).stdout.includes('--report');

/** A page that g31 itself writes; null where this g31 writes none. */
export const reportOf = (name, words) => reportBy(name, ['run', ...words]);

/** The same by any command that writes reports. */
export function reportBy(name, words) {
  return reportFrom(ROOT, words, path.join(folder, `${name}.html`));
}

/** The same by a command that is given beside the files that it names. */
export const reportBeside = (name, words) => reportFrom(folder, words, `${name}.html`);

function reportFrom(cwd, words, report) {
  if (!writesPages()) return null;
  const file = path.resolve(cwd, report);
  const done = spawnSync(path.resolve(G31_PROGRAM), [...words, '--report', report], { cwd, encoding: 'utf8' });
  if (!fs.existsSync(file)) throw new Error(`no page from g31: ${done.stderr}`);
  return file;
}

/** Keeps a document for documents_of_tests, as tests/tools/kept_documents.py does. */
function keep(name, file) {
  const kept = process.env.G31_KEPT_DOCUMENTS;
  if (!kept || !fs.existsSync(file)) return;
  fs.mkdirSync(kept, { recursive: true });
  fs.copyFileSync(file, path.join(kept, `${name}.json`));
}

/** The page of an inspection plan; null where this g31 makes none. */
export function planOf(name, words) {
  const plan = path.join(folder, name);
  const done = spawnSync(G31_PROGRAM, ['plan', ...words, '-o', plan], { cwd: ROOT, encoding: 'utf8' });
  const file = path.join(plan, 'plan.html');
  keep(name, path.join(plan, 'plan.json'));
  if (fs.existsSync(file)) return file;
  if (writesPages() && !done.stderr.includes('libocct')) throw new Error(`no plan from g31: ${done.stderr}`);
  return null;
}

/** A file beside the pages; its place. */
export function fileOf(name, text) {
  const file = path.join(folder, name);
  fs.writeFileSync(file, text);
  return file;
}

/** Opens a page; its notes hold requests to elsewhere and errors.
 * @param {{width?: number, theme?: string, before?: string}} [wish] before: script that runs ahead of the page's */
export async function open(browser, file, { width = 1400, theme = 'light', before = '' } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: theme });
  const page = await context.newPage();
  const notes = [];
  page.on('request', (request) => request.url().startsWith('http') && notes.push(`request ${request.url()}`));
  page.on('console', (message) => message.type() === 'error' && notes.push(`console ${message.text()}`));
  page.on('pageerror', (error) => notes.push(`error ${error.stack}`));
  if (before) await page.addInitScript(before);
  await page.goto(pathToFileURL(file).href);
  // Pages without motion have no scene.
  await page.waitForFunction(() => window.g31Timing?.scene != null || document.getElementById('scenebox') == null,
    null, { timeout: 60000 });
  return { page, notes, close: () => context.close() };
}

/** Of the scene: shares of its pixels that are drawn, and how many colours there are. */
export const pixelsOf = (page) => page.evaluate(() => {
  const scene = document.getElementById('scene');
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [scene.width, scene.height];
  const context = copy.getContext('2d');
  context.drawImage(scene, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  const colours = new Set();
  let drawn = 0;
  for (let at = 0; at < data.length; at += 4) {
    if (data[at + 3] < 128) continue;
    drawn += 1;
    colours.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
  }
  return { drawn: drawn / (data.length / 4), colours: colours.size, sum: data.reduce((sum, value) => sum + value, 0) };
});

/** Tries a check until it holds: what is drawn follows what was done in one of the next frames, on a busy computer later. */
export async function eventually(check, patience_ms = 20000) {
  for (const end = Date.now() + patience_ms; ; await new Promise((resolve) => { setTimeout(resolve, 50); })) {
    try {
      return await check();
    } catch (error) {
      if (Date.now() > end) throw error;
    }
  }
}
