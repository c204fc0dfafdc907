// How a page looks to whom: light and dark, narrow and magnified, for screen readers, without WebGL.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import test, { after, before } from 'node:test';
import { eventually, fileOf, launch, open, packages, pageOf, pixelsOf, planOf, reportBeside, reportBy } from './browser.mjs';
import { sampleRun } from './sample_run.mjs';

const AXE = fs.readFileSync(packages.resolve('axe-core/axe.min.js'), 'utf8');
const TAGS = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const ground = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

test('light and dark follow the system; the button overrides', async () => {
  const file = pageOf('themes', sampleRun());
  const light = await open(browser, file);
  const dark = await open(browser, file, { theme: 'dark' });
  assert.equal(await ground(light.page), 'rgb(243, 244, 245)');
  assert.equal(await ground(dark.page), 'rgb(14, 17, 19)');
  assert.notEqual((await pixelsOf(light.page)).sum, (await pixelsOf(dark.page)).sum);
  await dark.page.click('#theme');
  await eventually(async () => assert.equal(await ground(dark.page), 'rgb(243, 244, 245)'));
  await eventually(async () => assert.equal((await pixelsOf(light.page)).sum, (await pixelsOf(dark.page)).sum));
  await light.close();
  await dark.close();
});

// 400 % of a window of 1280 px leaves 320 px.
for (const width of [320, 350, 420, 1400]) {
  test(`nothing lies beside a window of ${width} px`, async () => {
    const { page, close } = await open(browser, pageOf(`narrow${width}`, sampleRun()), { width });
    const [wide, seen] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
    assert.ok(wide <= seen, `${wide} px`);
    const small = await page.evaluate(() => {
      const svg = document.querySelector('#chart svg');
      return svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
    });
    assert.ok(small > 0.95, 'figures are redrawn, not shrunk');
    await close();
  });
}

const LONG = 'Customer_4711_flange_left_side_operation_20_rev_C_probe_bore_and_face_2026-11.nc';

test('a name without a place to break at makes no page wider than its window', async (t) => {
  const file = reportBeside('long_name', ['run', fileOf(LONG, 'O1\n#100=1\nM30\n')]);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, close } = await open(browser, file);
  for (const width of [320, 400, 1280]) {
    await page.setViewportSize({ width, height: 900 });
    await eventually(async () => assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width, `${width} px`));
  }
  assert.equal(await page.getAttribute('.skip', 'href'), '#results');
  assert.match(await page.textContent('table#results'), /No results/);
  await close();
});

test('long printouts and many touches scroll by themselves', async (t) => {
  const lines = Array.from({ length: 500 }, (_, n) => `#100=${n}\nDPRNT[N#100[4]]`).join('\n');
  const file = reportBeside('printouts', ['run', fileOf('printouts.nc', `O1\nPOPEN\n${lines}\nPCLOS\nM30\n`)]);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, close } = await open(browser, file);
  const high = () => page.evaluate(() => document.querySelector('pre.out').getBoundingClientRect().height);
  assert.ok(await high() < 700);
  await page.emulateMedia({ media: 'print' });
  assert.ok(await high() > 5000);
  await close();
  const long = await open(browser, pageOf('many', sampleRun({ rounds: 40 })));
  await long.page.evaluate(() => [...document.querySelectorAll('#chart g[data-t]')].at(-1).dispatchEvent(new MouseEvent('click', { bubbles: true })));
  const [row, box] = await long.page.evaluate(() => ['tr.sel', '.tw.tall'].map((one) => document.querySelector(one).getBoundingClientRect()));
  assert.ok(box.height < 700 && row.top > box.top && row.bottom < box.bottom, 'the chosen row is in sight of its table');
  await long.close();
});

test('what is chosen is seen where the system forces its colours', async () => {
  const { page, close } = await open(browser, pageOf('forced', sampleRun()));
  await page.click('tr[data-touch="3"] td:nth-child(3)');
  await page.emulateMedia({ forcedColors: 'active' });
  const grounds = (/** @type {string} */ one) => page.evaluate((css) => getComputedStyle(document.querySelector(css)).backgroundColor, one);
  for (const [chosen, other] of [['#planhead [aria-pressed=true]', '#planhead [aria-pressed=false]'], ['#ltabs [aria-pressed=true]', '#ltabs [aria-pressed=false]'],
    ['[data-view=section]', '[data-view=iso]'], ['.scene-labels .badge.sel', '.scene-labels .badge:not(.sel)'], ['tr.sel td', 'tr[data-touch]:not(.sel) td']]) {
    assert.notEqual(await grounds(chosen), await grounds(other), chosen);
  }
  await close();
});

/** A record of a circle of 50 mm, 5 um too large. */
function circleRecord() {
  const rows = Array.from({ length: 721 }, (_, n) => [n / 100, 50.005 * Math.cos(n * Math.PI / 360), 50.005 * Math.sin(n * Math.PI / 360)]);
  return fileOf('circle.csv', ['t,X,Y', ...rows, ''].join('\n'));
}

const RING = 'parts/library/ring_gauge';
const KINEMATICS = 'parts/library/kinematics_ball';
for (const [name, file] of [
  ['evaluate', () => reportBy('circle', ['evaluate', 'circle', circleRecord(), '--radius', '50', '--centre', '0,0'])],
  ['plan', () => planOf('narrow_plan', ['parts/library/inspection/product.step', '--stock', 'box'])],
  ['run', () => reportBy('ring_results', ['run', `${RING}/measure_ring.nc`, '-s', `${RING}/ring.toml`, '--expect', '#164=40+-0.01'])],
  ['run of many touches', () => reportBy('kinematics', ['run', `${KINEMATICS}/measure_kinematics.mpf`, '-s', `${KINEMATICS}/kinematics_ball.toml`])],
]) {
  test(`pages fit windows of a tablet: ${name}`, async (t) => {
    const page_ = file();
    if (page_ === null) return t.skip('this g31 writes no such page');
    const { page, notes, close } = await open(browser, page_);
    for (const width of [320, 420, 700, 820, 900, 1000, 1100, 1300]) {
      await page.setViewportSize({ width, height: 900 });
      await eventually(async () => assert.deepEqual(await page.evaluate(() => {
        const { scrollWidth, clientWidth } = document.documentElement;
        const spills = (/** @type {Element} */ e) => e.scrollWidth > e.clientWidth + 1;
        return { beside: Math.max(0, scrollWidth - clientWidth), bar: [...document.querySelectorAll('.now')].filter(spills).length,
          cells: [...document.querySelectorAll('#results td')].filter((cell) => cell.clientWidth > 0 && spills(cell)).map((cell) => cell.textContent) };
      }), { beside: 0, bar: 0, cells: [] }, `${width} px`));
    }
    assert.deepEqual(notes, []);
    await close();
  });
}

test('the numbers of a result stand in one row in a window of a laptop', async (t) => {
  const file = planOf('narrow_plan', ['parts/library/inspection/product.step', '--stock', 'box']);
  if (file === null) return t.skip('this g31 writes no such page');
  const { page, close } = await open(browser, file, { width: 1280 });
  for (const width of [1280, 1360, 1440]) {
    await page.setViewportSize({ width, height: 900 });
    await eventually(async () => assert.equal(await page.evaluate(() =>
      new Set([...document.querySelectorAll('#results tbody tr:first-child td.n')].map((cell) => {
        const { top, bottom } = cell.getBoundingClientRect();
        return Math.round((top + bottom) / 2);
      })).size), 1, `${width} px`));
  }
  await close();
});

test('a picture that is wider than its window fades out where more of it lies; the table of results fits', async (t) => {
  const file = reportBy('circle', ['evaluate', 'circle', circleRecord(), '--radius', '50', '--centre', '0,0']);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, close } = await open(browser, file, { width: 360 });
  const isBeside = () => page.evaluate(() => document.querySelector('.drawing').classList.contains('beside'));
  await eventually(async () => assert.ok(await isBeside()));
  await page.evaluate(() => { document.querySelector('.drawing').scrollLeft = 1e4; });
  await eventually(async () => assert.ok(!await isBeside(), 'nothing more lies there'));
  assert.deepEqual(await page.evaluate(() => {
    const box = document.getElementById('results').parentElement;
    return [box.scrollWidth - box.clientWidth, box.scrollHeight - box.clientHeight];
  }), [0, 0]);
  await close();
});

test('paper is light, drawings too, where the system is dark', async (t) => {
  const file = reportBy('circle', ['evaluate', 'circle', circleRecord(), '--radius', '50', '--centre', '0,0']);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, close } = await open(browser, file, { theme: 'dark' });
  const paper = () => page.evaluate(() => getComputedStyle(document.querySelector('.drawing .paper')).fill);
  assert.equal(await paper(), 'rgb(20, 24, 28)');
  await page.emulateMedia({ media: 'print' });
  assert.equal(await paper(), 'rgb(255, 255, 255)');
  await close();
});

test('a drawing goes by the theme of its page and leaves the texts of figures as they are', async (t) => {
  const file = planOf('themes_plan', ['parts/library/inspection/product.step', '--stock', 'box']);
  if (file === null) return t.skip('this g31 makes no plans');
  const { page, close } = await open(browser, file);
  await page.keyboard.press(']');
  const inks = () => page.evaluate(() => ['.drawing .paper', '.drawing .title', '#chart text[fill="var(--paper)"]', '#chart text[fill="var(--ink2)"]']
    .map((css) => getComputedStyle(document.querySelector(css)).fill));
  const light = ['rgb(255, 255, 255)', 'rgb(28, 35, 41)', 'rgb(255, 255, 255)', 'rgb(71, 80, 90)'];
  const dark = ['rgb(20, 24, 28)', 'rgb(230, 235, 239)', 'rgb(21, 24, 27)', 'rgb(179, 187, 195)'];
  assert.deepEqual(await inks(), light);
  await page.click('#theme');
  await eventually(async () => assert.deepEqual(await inks(), dark));
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.click('#theme');
  await eventually(async () => assert.deepEqual(await inks(), light, 'the button, not the system'));
  await close();
});

test('an evaluation says nothing of a simulation: its rows may be those of a machine', async (t) => {
  const file = reportBy('circle', ['evaluate', 'circle', circleRecord(), '--radius', '50', '--centre', '0,0']);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, close } = await open(browser, file);
  const text = await page.textContent('#inputs');
  assert.doesNotMatch(text, /simulation/);
  assert.match(text, /the rows of this file, wherever they come from/);
  await close();
});

for (const [name, run] of [['plain', sampleRun()], ['crash', sampleRun({ crash: true })]]) {
  for (const width of [500, 1400]) {
    test(`axe finds nothing: ${name}, ${width} px, light and dark`, async () => {
      const { page, close } = await open(browser, pageOf(`axe_${name}`, run), { width });
      await page.evaluate(AXE);
      const seen = [];
      for (const colorScheme of ['light', 'dark']) {
        await page.emulateMedia({ colorScheme });
        seen.push(await ground(page));
        const { violations } = await page.evaluate((tags) => axe.run(document, { runOnly: tags }), TAGS);
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`), [], colorScheme);
      }
      assert.equal(new Set(seen).size, 2);
      await close();
    });
  }
}

test('without WebGL a sketch stands for the scene, and all else works', async () => {
  const before_ = 'const get = HTMLCanvasElement.prototype.getContext;'
    + 'HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return /webgl/.test(kind) ? null : get.call(this, kind, ...rest); };';
  const { page, notes, close } = await open(browser, pageOf('flat', sampleRun()), { before: before_ });
  assert.equal(await page.locator('#scenebox canvas').count(), 0);
  assert.ok((await page.locator('svg#scene path').first().getAttribute('d')).length > 1000);
  assert.match(await page.textContent('#scenebox'), /no 3D graphics/);
  await page.click('tr[data-touch="9"] td:nth-child(3)');
  await page.locator('.scene-labels .badge.sel', { hasText: /^9$/ }).waitFor({ timeout: 10000 });
  assert.deepEqual(notes, []);
  await close();
});
