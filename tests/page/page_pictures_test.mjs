// Screenshots that the manual shows: what a reader sees who follows the tutorial is what they show.
//
// G31_UPDATE_PICTURES=1 writes them anew; look at them then.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { fileOf, launch, open, reportBeside } from './browser.mjs';

const DOCS = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../docs');
const SIZE = { width: 1200, height: 900 };
// Of all pixels: letters may be those of another font, a figure that is missing is far more (a part is light grey).
const MOST_DIFFERENT = 0.04;

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** Writes the files of a tutorial beside the pages. */
function writeFilesOf(tutorial) {
  const text = fs.readFileSync(path.join(DOCS, 'tutorials', `${tutorial}.md`), 'utf8');
  for (const [, name, content] of text.matchAll(/^```\{[^}]*title="([^"]+)"\}\n([\s\S]*?)^```$/gm)) fileOf(name, content);
}

/** What is on the screen.
 * @param {(page: import('playwright-core').Page) => Promise<void>} [act] */
async function screenOf(file, theme, act) {
  const { page, notes, close } = await open(browser, file, { width: SIZE.width, theme });
  await page.setViewportSize(SIZE);
  await act?.(page);
  await page.waitForTimeout(400);
  const png = await page.screenshot({ animations: 'disabled', caret: 'hide' });
  assert.deepEqual(notes, []);
  await close();
  return png;
}

/** The share of pixels that differ by more than a little; 1 where the sizes do. @param {Buffer} one @param {Buffer} other */
async function differenceOf(one, other) {
  const page = await browser.newPage();
  const urls = [one, other].map((png) => `data:image/png;base64,${png.toString('base64')}`);
  const share = await page.evaluate(async (images) => {
    const [a, b] = await Promise.all(images.map(async (url) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.width, image.height);
    }));
    if (a.width !== b.width || a.height !== b.height) return 1;
    let different = 0;
    for (let n = 0; n < a.data.length; n += 4) {
      if ([0, 1, 2].some((channel) => Math.abs(a.data[n + channel] - b.data[n + channel]) > 12)) ++different;
    }
    return different / (a.data.length / 4);
  }, urls);
  await page.close();
  return share;
}

/** @param {string} picture below docs @param {Buffer} made */
async function expectAsShown(picture, made) {
  const file = path.join(DOCS, picture);
  if (process.env.G31_UPDATE_PICTURES) fs.writeFileSync(file, made);
  const share = await differenceOf(fs.readFileSync(file), made);
  assert.ok(share <= MOST_DIFFERENT, `${picture}: ${(100 * share).toFixed(1)} % of the pixels are others`);
}

/** The report of the bore in the tutorial for a Fanuc shop, by its command; null where this g31 writes no pages. */
function boreReport() {
  writeFilesOf('fanuc-shop');
  return reportBeside('report', ['run', 'bore.nc', '-s', 'machine.toml', '-s', 'flange.toml']);
}

for (const [picture, theme, act] of [
  ['tutorials/report.png', 'light', null],
  ['tutorials/report-touch.png', 'dark', async (page) => {
    await page.click('tr[data-touch="3"] td:nth-child(3)');
    await page.locator('#scenebox').evaluate((box) => box.closest('section').scrollIntoView());
  }],
]) {
  test(`${picture} shows what a reader sees`, async (t) => {
    const file = boreReport();
    if (file === null) return t.skip('this g31 writes no pages');
    return expectAsShown(picture, await screenOf(file, theme, act));
  });
}

test('a picture without its figures is another one', async (t) => {
  const file = boreReport();
  if (file === null) return t.skip('this g31 writes no pages');
  const whole = await screenOf(file, 'light', null);
  const without = await screenOf(file, 'light', (page) => page.addStyleTag({ content: '#plan, #scenebox { visibility: hidden }' }));
  assert.ok(await differenceOf(whole, without) > MOST_DIFFERENT);
});
