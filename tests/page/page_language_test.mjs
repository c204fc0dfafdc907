// Japanese pages: whatever a person reads or hears on them is Japanese, but for names, codes and units, comments of
// programs (lang=""), and what is marked as English: messages, which are the same on every page.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { fileOf, launch, open, planOf, reportBy } from './browser.mjs';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const UNITS = ['mm', 'µm', 'um', 'deg', 'min', 'ms', 'mm/min', 'µm/m'];
// Names of things that are called so in Japanese as well, and letters that stand for quantities.
const NAMES = ['Ctrl', 'g31', 'SHA-256', 'WebGL', 'MEAS', 'MSG', 'XY', 'XZ', 'YZ', '--expect', '--print'];
const SHAPES = [
  /^[A-Z]{1,8}[\d_]+(\.\d+)?$/, // G31, O9010, PRB301, CYCLE977
  /^[#$_]/, // variables
  /^[A-Za-z]+(_\w+)+$/, // results in documents
  /\.\w+$/, // files
  /^[a-z]+(-\d+\w*)+$/, // fanuc-16i
  /^[0-9a-f]{8,}$/, // hashes
];

/** Everything on the page that is read or heard, with the element that it is of. */
const said = (page) => page.evaluate(() => {
  const skipped = '[lang="en"], [lang=""], script, style, code, pre, .mono, .tx, .hash';
  const found = [];
  const add = (element, text) => {
    if (text.trim() !== '' && !element.closest(skipped)) found.push(text.trim());
  };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) add(walker.currentNode.parentElement, walker.currentNode.data);
  for (const name of ['aria-label', 'title', 'alt', 'placeholder']) {
    for (const element of document.querySelectorAll(`[${name}]`)) add(element, element.getAttribute(name));
  }
  add(document.body, document.title);
  return found;
});

/** Latin words of a text that are neither names nor units. */
function foreignWords(text, names) {
  let rest = text;
  for (const name of names.filter((one) => one.includes(' '))) rest = rest.replaceAll(name, ' ');
  const words = rest.match(/(--)?[A-Za-zµ#$_][\w.$#-]*/g) ?? [];
  const known = [...UNITS, ...NAMES, ...names];
  return words.map((word) => word.replace(/\.$/, ''))
    .filter((word) => word.length > 1 && !known.includes(word) && !SHAPES.some((shape) => shape.test(word)));
}

async function expectJapanese(file, names) {
  const { page, notes, close } = await open(browser, file);
  assert.equal(await page.getAttribute('html', 'lang'), 'ja');
  const texts = await said(page);
  assert.ok(texts.length > 10 && texts.some((text) => /[\u3040-\u30ff\u4e00-\u9fff]/.test(text)), 'there is Japanese on it');
  const wrong = texts.map((text) => [text, foreignWords(text, names)]).filter(([, words]) => words.length > 0);
  assert.deepEqual([...new Set(wrong.map(([text, words]) => `${words.join(' ')} in: ${text.slice(0, 100)}`))], []);
  assert.deepEqual(notes, []);
  await close();
}

const RING = 'parts/library/ring_gauge/';
const SHEETS = ['-s', `${RING}ring.toml`, '-s', `${RING}late_probe.toml`];

/** @param {() => string[]} words of the command line
 * @param {string[]} names of the program and its set-up */
function japanese(title, words, names) {
  test(title, async (t) => {
    const file = reportBy(`ja_${title.replaceAll(/\W/g, '_')}`, [...words(), '--lang', 'ja']);
    if (file === null) return t.skip('this g31 writes no pages');
    return expectJapanese(file, names);
  });
}

japanese('a run with results', () => ['run', `${RING}measure_ring.nc`, ...SHEETS, '-s', `${RING}diameters.toml`],
  ['Bore of the ring, X', 'Bore of the ring, Y', 'measure_ring', 'ring']);

japanese('a run of measuring cycles', () => ['run', `${RING}measure_ring.mpf`, '-s', `${RING}sinumerik.toml`, '--print', '_OVR[4]'],
  ['sinumerik-828d', 'measure_ring', 'ring']);

japanese('a run that is not as expected', () => ['run', `${RING}measure_ring.nc`, ...SHEETS, '--expect', '#164=39+-0.001'], ['DIAMETER X', 'measure_ring', 'ring']);

japanese('an alarm', () => ['run', fileOf('alarm.nc', 'O7\nG90 G59 G00 X0 Y0\nIF [#1 EQ #0] GOTO 5\nN5 G65 P9010 U50. Z-7.5 A1.\nM30\n'), 'macros/fanuc/O9010.nc', ...SHEETS],
  ['DATA EMPTY', 'alarm', 'ring']);

japanese('a collision', () => ['run', fileOf('crash.nc', 'O7\nG90 G59 G00 X0 Y0\nG43 H99 Z-10.\nG01 X30. F500.\nM30\n'), ...SHEETS], ['crash', 'ring']);

japanese('a set-up that is refused', () => ['run', `${RING}measure_ring.nc`, '-s', fileOf('wrong.toml', '[prob]\n')], []);

japanese('a study', () => ['study', fileOf('study.toml', `
[study]
name = "study of one"
program = "${fileOf('one.nc', 'O1\n#500=1.5\nM30\n')}"
repeats = 6
[results.one]
value = "#500"
expected = 1.4
published = [1.45]
`)], ['study of one', 'one']);

/** A way round and back, as a file; its points by the share of the whole. */
const pathFile = (name, pointAt) => {
  const share = (i) => (i <= 720 ? i : 1440 - i) / 720;
  const rows = Array.from({ length: 1441 }, (_, i) => `${(i * 0.01).toFixed(3)},${pointAt(share(i)).map((x) => x.toFixed(6)).join()}`);
  return fileOf(name, `t,X,Y\n${rows.join('\n')}\n`);
};
const circle = () => pathFile('circle.csv', (s) => [50.01 * Math.cos(2 * Math.PI * s), 50 * Math.sin(2 * Math.PI * s)]);
const square = () => pathFile('square.csv', (s) => {
  const [side, along] = [Math.floor(4 * s) % 4, 100 * ((4 * s) % 1) - 50];
  return [[50, along], [-along, 50], [-50, -along], [along, -50]][side];
});
// Every kind of evaluation, with its drawing: words of results in documents are names.
const EVALUATIONS = {
  circle: () => [circle(), '--radius', '50'],
  square: () => [square(), '--side', '100'],
  speed: () => [square()],
  diagonal: () => [square(), '--target', '50,-50'],
  straightness: () => [fileOf('bed.csv', 'A,B\n0,1\n0,-1\n0,0\n'), '--step', '100'],
  flatness: () => [fileOf('plate.csv', 'x,y,z\n0,0,0\n1,0,0.001\n0,1,0\n1,1,0\n')],
  cylindricity: () => [fileOf('shaft.csv', 'theta,A,B\n0,1,1\n0,1,1\n90,1,1\n90,1,1\n180,1,1\n180,1,1\n270,1.001,1\n270,1,1\n'),
    '--step', '100', '--diameters', fileOf('ends.csv', 'K,d\n0,20\n1,20\n')],
  positioning: () => [fileOf('x.csv', 'axis,target,direction,cycle,position\nX,0,1,1,0.001\nX,0,1,2,0.002\nX,9,1,1,9\n'
    + 'X,9,1,2,9.001\nX,0,-1,1,0.004\nX,0,-1,2,0.003\nX,9,-1,1,9\nX,9,-1,2,9.002\n')],
};
for (const [kind, words] of Object.entries(EVALUATIONS)) {
  japanese(`an evaluation: ${kind}`, () => ['evaluate', kind, ...words()], ['squareness', 'hysteresis', 'radius', 'side', 'delta', 'parallelism']);
}

test('a plan', async (t) => {
  const file = planOf('ja_plan', ['parts/library/inspection/product.step', '--stock', 'box', '--lang', 'ja']);
  if (file === null) return t.skip('this g31 reads no STEP files, or writes no pages');
  return expectJapanese(file, ['inspect', 'product', 'g31 plan']);
});
