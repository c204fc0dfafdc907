// Program text is only ever text; a page may have any of its parts missing.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import test, { after, before } from 'node:test';
import { fileOf, launch, open, pageOf, reportBy } from './browser.mjs';
import { sampleRun } from './sample_run.mjs';
import { joined } from '../../tools/page/web/src/edge_chains.js';

const HOSTILE = '</script><script>window.bad = 1</script><img src=x onerror="window.bad = 2"> "\' &amp; <!-- \u2028';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

test('a rim of thousands of pieces is drawn as few, a corner and a fork stay', () => {
  const at = (n) => [20 * Math.cos((n * Math.PI) / 2000), 20 * Math.sin((n * Math.PI) / 2000), 5];
  const rim = Array.from({ length: 4000 }, (_, n) => [...at(n), ...at(n + 1)]);
  const pieces = joined(rim.toReversed().flat(), 0.006);
  assert.ok(pieces.length / 6 > 60 && pieces.length / 6 < 300, `${pieces.length / 6} pieces`);
  for (let n = 0; n < pieces.length; n += 3) assert.ok(Math.abs(Math.hypot(pieces[n], pieces[n + 1]) - 20) < 1e-9);
  const length = (ends) => Array.from({ length: ends.length / 6 }, (_, n) =>
    Math.hypot(...[0, 1, 2].map((axis) => ends[6 * n + axis] - ends[6 * n + 3 + axis]))).reduce((sum, one) => sum + one, 0);
  assert.ok(Math.abs(length(pieces) - 40 * Math.PI) < 0.1, 'it is closed');
  const [a, b, c, d, e] = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 3, 0], [2, 0, 4]];
  const open_ = joined([...a, ...b, ...c, ...b, ...c, ...d, ...e, ...c], 0.01);
  assert.equal(open_.length, 18);
  assert.ok(Math.abs(length(open_) - 9) < 1e-9);
});

test('markup in programs and names is shown, not obeyed', async () => {
  for (const lines of [60, 3000]) {
    const run = sampleRun({ lines, text: (line) => (line === 38 ? HOSTILE : line === 39 ? 'X'.repeat(200000) : `N${line}`) });
    run.document.calls[1].program = HOSTILE;
    run.document.touches[2].part = HOSTILE;
    run.figures.parts[0].name = HOSTILE;
    const { page, notes, close } = await open(browser, pageOf(`hostile${lines}`, run));
    await page.click('#next');
    await page.click('#next');
    assert.equal(await page.evaluate(() => window.bad), undefined);
    assert.deepEqual(notes, []);
    assert.match(await page.textContent('#listing'), /<\/script><script>window\.bad = 1/);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
    await close();
  }
});

test('any part of the page may be missing', async () => {
  for (const ids of ['plan|planhead', 'scenebox|plancap|timeline', 'chart|now|allt|ltabs', 'touches|listing']) {
    const file = pageOf('without', sampleRun());
    fs.writeFileSync(file, fs.readFileSync(file, 'utf8').replace(new RegExp(`id="(${ids})"`, 'g'), 'data-gone="$1"'));
    const { page, notes, close } = await open(browser, file);
    await page.keyboard.press(']');
    assert.deepEqual(notes, [], ids);
    await close();
  }
});

test('a document without figures or moves draws what there is', async () => {
  const { document } = sampleRun();
  const bare = { ...document, moves: undefined, calls: undefined, counts: undefined };
  const { notes, close } = await open(browser, pageOf('bare', { document: { ...bare, counts: [] }, figures: { listing: [] } }));
  assert.deepEqual(notes, []);
  await close();
});

test('a run in which nothing moves says so', async (t) => {
  const file = reportBy('still', ['run', fileOf('wrong.nc', 'O1\n#1=[1\nM30\n'), '-s', 'parts/library/ring_gauge/ring.toml']);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, notes, close } = await open(browser, file);
  assert.equal((await page.textContent('#chart')).trim(), 'Nothing moved: there is no time to show.');
  assert.doesNotMatch(await page.innerText('body'), /drawn by the script/);
  assert.deepEqual(notes, []);
  await close();
});
