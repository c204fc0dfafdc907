// Long runs open quickly.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import test, { after, before } from 'node:test';
import { launch, open, pageOf } from './browser.mjs';
import { sampleRun } from './sample_run.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

/** Seconds that the processor was busy for a page since it was opened: not those that it was busy for others. */
async function secondsOf(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  await page.reload();
  await page.waitForFunction(() => window.g31Timing?.ready != null, null, { timeout: 60000 });
  const { metrics } = await session.send('Performance.getMetrics');
  return metrics.find(({ name }) => name === 'TaskDuration').value;
}

test('10,000 touches and 100,000 lines: 8 MB at most, ready in 2 s, all rows within reach', async () => {
  const run = sampleRun({ rounds: 417, lines: 100000 });
  assert.ok(run.document.touches.length >= 10000);
  const file = pageOf('long', run);
  assert.ok(fs.statSync(file).size < 8e6, `${fs.statSync(file).size} bytes`);
  const { page, close } = await open(browser, file);
  const busy = await secondsOf(page);
  assert.ok(busy > 0.05 && busy < 2, `${busy} s`);
  assert.ok(await page.locator('#listing li').count() < 200);
  await page.evaluate(() => { document.getElementById('listing').scrollTop = 1e9; });
  await page.waitForSelector('#listing li[data-l="100000"]');
  await page.keyboard.press('[');
  const number = await page.locator('#touches tr.sel').getAttribute('data-touch');
  const hits = run.document.touches.map((touch, n) => (touch.triggered ? n + 1 : 0)).filter(Boolean);
  assert.equal(Number(number), hits.at(-2));
  await close();
});
