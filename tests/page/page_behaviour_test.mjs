// What a reader does with a page: choose, scrub, play, turn, print, with pointer and keys.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { eventually, launch, open, pageOf, pixelsOf, reportOf } from './browser.mjs';
import { sampleRun } from './sample_run.mjs';

const RING = 'parts/library/ring_gauge';
const PROGRAM = [`${RING}/measure_ring.nc`, '--setup', `${RING}/ring.toml`, '--setup', `${RING}/late_probe.toml`];

let browser;
let opened;
before(async () => {
  browser = await launch();
  opened = await open(browser, pageOf('run', sampleRun()));
});
after(() => browser.close());

const time = (page) => page.evaluate(() => Number(document.getElementById('timeline').value));
const chosen = (page) => page.evaluate(() => [...document.querySelectorAll('#touches tr.sel')].map((row) => Number(row.dataset.touch)));
const line = (page) => page.evaluate(() => {
  const row = document.querySelector('#listing li.cur');
  return row && `${row.closest('ol').dataset.file}:${row.dataset.l}`;
});

test('the scene is drawn', async () => {
  const { drawn, colours } = await pixelsOf(opened.page);
  assert.ok(drawn > 0.1, `${drawn} of it`);
  assert.ok(colours > 20, `${colours} colours`);
});

test('a touch chosen in the table is chosen everywhere, and the playhead goes there', async () => {
  const { page } = opened;
  await page.click('tr[data-touch="9"] td:nth-child(3)');
  const { time_s, file, line: at } = sampleRun().document.touches[8];
  assert.deepEqual(await chosen(page), [9]);
  assert.ok(Math.abs(await time(page) - time_s) < 0.001);
  assert.equal(await line(page), `${file}:${at}`);
  await eventually(async () => assert.equal(await page.locator('.scene-labels .badge.sel').textContent(), '9'));
  for (const figure of ['#plan', '#chart']) {
    assert.equal(await page.locator(`${figure} g[data-t="9"] rect`).getAttribute('fill'), 'var(--accent)');
  }
});

test('numbers in plan, scene and time line choose, too', async () => {
  const { page } = opened;
  for (const [place, number] of [['#chart g[data-t="6"]', 6], ['#plan g[data-t="12"]', 12], ['.scene-labels [data-t="15"]', 15]]) {
    await page.locator(place).click();
    assert.deepEqual(await chosen(page), [number], place);
  }
});

test('scrubbing moves the playhead and the line, and leaves the chosen touch', async () => {
  const { page } = opened;
  const before_ = await chosen(page);
  const run = sampleRun().document;
  const box = await page.locator('#chart svg').boundingBox();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height - 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height - 40);
  await page.mouse.up();
  const now = await time(page);
  const wanted = ((box.width * 0.5 - 86) / (box.width - 100)) * run.machine_time_s;
  assert.ok(Math.abs(now - wanted) < 0.1, `${now} s, not ${wanted} s`);
  assert.deepEqual(await chosen(page), before_);
  const move = run.moves.find((each) => each.time_s >= now);
  assert.equal(await line(page), `${move.file}:${move.line}`);
});

test('keys: touch before and next, play and pause, arrows on the range, arrows on the scene', async () => {
  const { page } = opened;
  await page.click('tr[data-touch="3"] td:nth-child(3)');
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press(']');
  assert.deepEqual(await chosen(page), [5]);
  await page.keyboard.press('[');
  assert.deepEqual(await chosen(page), [3]);
  const before_ = await time(page);
  await page.keyboard.press(' ');
  await page.waitForFunction((from) => Number(document.getElementById('timeline').value) > from + 0.1, before_);
  await page.keyboard.press(' ');
  await page.waitForTimeout(300);
  const played = await time(page);
  await page.waitForTimeout(300);
  assert.equal(await time(page), played, 'it stands');
  await page.focus('#timeline');
  await page.keyboard.press('ArrowRight');
  assert.ok(await time(page) > played);
  const { sum } = await pixelsOf(page);
  await page.focus('#scene');
  await page.keyboard.press('ArrowLeft');
  await eventually(async () => assert.notEqual((await pixelsOf(page)).sum, sum, 'it turns'));
});

test('a drag that begins on a number turns the scene, a click there chooses', async () => {
  const { page } = opened;
  await page.click('[data-view="iso"]');
  await page.click('tr[data-touch="9"] td:nth-child(3)');
  const label = () => page.evaluate(() => {
    const badge = document.querySelector('.scene-labels .badge:not(.sel)'); // another one with each drawing
    const { x, y, width, height } = badge.getBoundingClientRect();
    return { number: Number(badge.textContent), at: [x + width / 2, y + height / 2] };
  });
  await page.evaluate(() => document.getElementById('scenebox').scrollIntoView({ block: 'center' }));
  const { sum } = await pixelsOf(page);
  const [x, y] = (await label()).at;
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 30, { steps: 6 });
  await page.mouse.up();
  await eventually(async () => assert.notEqual((await pixelsOf(page)).sum, sum, 'it turns'));
  assert.equal(await page.evaluate(() => getSelection().toString()), '');
  assert.deepEqual(await chosen(page), [9], 'nothing else is chosen');
  const turned = (await pixelsOf(page)).sum;
  await page.mouse.move(...(await label()).at);
  await page.mouse.wheel(0, -200);
  await eventually(async () => assert.notEqual((await pixelsOf(page)).sum, turned, 'it has the focus, and comes nearer'));
  const { number, at } = await label();
  await page.mouse.click(...at);
  assert.deepEqual(await chosen(page), [number]);
});

test('the section can be closed, views be chosen', async () => {
  const { page } = opened;
  await page.click('[data-view="iso"]');
  await page.waitForTimeout(200);
  const open_ = await pixelsOf(page);
  await page.click('[data-view="section"]');
  await eventually(async () => assert.notEqual((await pixelsOf(page)).sum, open_.sum));
  await page.click('[data-view="z"]');
  await eventually(async () => assert.ok((await pixelsOf(page)).drawn > 0.1));
});

test('lines, files and ways without a signal answer', async () => {
  const { page } = opened;
  await page.click('#ltabs button[data-file="main.nc"]');
  assert.equal(await page.evaluate(() => [...document.querySelectorAll('#listing ol')].filter((ol) => !ol.hidden).length), 1);
  await page.click('tr[data-touch="2"] a[data-go]');
  assert.equal(await line(page), 'O9010.nc:26');
  const rows = () => page.evaluate(() => [...document.querySelectorAll('#touches tbody tr')].filter((row) => row.offsetHeight).length);
  assert.equal(await rows(), 16);
  await page.check('#allt');
  assert.equal(await rows(), 24);
});

test('paper is A4, has a picture of the scene, and the page is as before afterwards', async () => {
  const { page, close } = await open(browser, pageOf('paper', sampleRun()), { theme: 'dark' });
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.equal(await page.locator('.scene-picture').count(), 1);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
  await page.evaluate(() => dispatchEvent(new Event('afterprint')));
  assert.equal(await page.locator('.scene-picture').count(), 0);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme ?? ''), '');
  const pdf = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString('latin1');
  const pages = (pdf.match(/\/Type \/Page\b(?!s)/g) ?? []).length;
  assert.ok(pages >= 1 && pages <= 4, `${pages} pages`);
  const [, width, height] = pdf.match(/\/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/).map(Number);
  assert.ok(Math.abs(width - 595) < 2 && Math.abs(height - 842) < 2, `${width} x ${height} points`);
  await close();
});

test('paper has every program, under its name', async () => {
  const { page, close } = await open(browser, pageOf('listings', sampleRun()));
  await page.emulateMedia({ media: 'print' });
  const shown = await page.evaluate(() => [...document.querySelectorAll('#listing ol, #listing h3')].map((one) =>
    [one.tagName, one.dataset.file ?? one.textContent, one.getBoundingClientRect().height > 10]));
  assert.deepEqual(shown, [['H3', 'main.nc', true], ['OL', 'main.nc', true], ['H3', 'O9010.nc', true], ['OL', 'O9010.nc', true]]);
  await close();
});

test('nothing was asked of anyone, and no error was told', () => assert.deepEqual(opened.notes, []));

test('a page that g31 writes has its figures', async (t) => {
  const file = reportOf('ring', PROGRAM);
  if (!file) return t.skip('this g31 has no run --report');
  const { page, notes, close } = await open(browser, file);
  assert.ok((await pixelsOf(page)).drawn > 0.05);
  assert.ok(await page.locator('#plan svg').count() === 1 && await page.locator('#chart svg').count() === 1);
  await page.keyboard.press(']');
  assert.equal((await chosen(page)).length, 1);
  assert.deepEqual(notes, []);
  await close();
});

test('the axes that a page of g31 shows accelerate', async (t) => {
  const file = reportOf('ramp', PROGRAM);
  if (!file) return t.skip('this g31 has no run --report');
  const { page, close } = await open(browser, file);
  const { ways, frame } = await page.evaluate(() => JSON.parse(document.getElementById('g31-figures').textContent));
  const { points, time_s: [from] } = ways.find(({ kind }) => kind === 'rapid');
  const way = [0, 1, 2].map((axis) => points[3 + axis] - points[axis]);
  const most = Math.max(...way.map(Math.abs));
  const after = 0.05;
  const gone = (2000 / 2) * after * after; // mm of the axis that goes farthest, 2000 mm/s2
  await page.evaluate((time) => {
    const range = document.getElementById('timeline');
    range.value = String(time);
    range.dispatchEvent(new Event('input'));
  }, from + after);
  const shown = (await page.textContent('#now')).replaceAll('−', '-').match(/X (\S+)\s+Y (\S+)\s+Z (-?[\d.]{5,})/).slice(1, 4).map(Number);
  shown.forEach((value, axis) => {
    const wanted = points[axis] + (gone / most) * way[axis] - frame.origin[axis];
    assert.ok(Math.abs(value - wanted) < 0.00075, `${shown}, ${wanted} of axis ${axis}`);
  });
  await close();
});
