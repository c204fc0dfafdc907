// Begins: reads what the page holds, draws the figures, links what belongs together.
import { Choice } from './choice.js';
import { drawLegends } from './legends.js';
import { Listing } from './listing.js';
import { followEditions, restoreTheme } from './live.js';
import { byId } from './markup.js';
import { jsonOf, named, partsOf } from './page_data.js';
import { markOverflow } from './overflow.js';
import { Plan } from './plan.js';
import { keepPrintable } from './print.js';
import { Run } from './run.js';
import { Scene } from './scene.js';
import { apexOf } from './scene_content.js';
import { Timeline } from './timeline.js';
import { TouchTable } from './touch_table.js';
import { Transport } from './transport.js';
import { useWords, word } from './words.js';

const RESIZE_REST = 60; // ms without a change of size before figures are drawn anew

/** @param {() => void} changed the colours of the page */
function linkTheme(changed) {
  byId('theme')?.addEventListener('click', () => {
    const root = document.documentElement;
    const isDark = root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme:dark)').matches;
    root.dataset.theme = isDark ? 'light' : 'dark';
    changed();
  });
  matchMedia('(prefers-color-scheme:dark)').addEventListener('change', changed);
}

/** The command on one line, as a shell takes it. */
function linkCopy() {
  const button = byId('copy');
  button?.addEventListener('click', () => {
    const text = (byId('command')?.textContent ?? '').replace(/\s*\\\n\s*/g, ' ').trim();
    navigator.clipboard?.writeText(text).catch(() => {}); // a page opened from disk may not be allowed to
    button.textContent = word('copied');
  });
}

/** Touches, lines and times that are named anywhere on the page.
 * @param {Choice} choice @param {Listing} listing */
function linkEverything(choice, listing) {
  document.addEventListener('click', (event) => {
    const target = /** @type {Element} */ (event.target);
    const link = /** @type {HTMLElement | null} */ (target.closest('[data-t], [data-go], [data-time]'));
    if (!link) return;
    const { t, go, time } = link.dataset;
    if (t) return choice.choose(Number(t));
    if (time) return choice.moveTo(Number(time));
    if (!go) return;
    event.preventDefault();
    const colon = go.lastIndexOf(':');
    listing.go(go.slice(0, colon), Number(go.slice(colon + 1)));
    const isFar = link.tagName === 'A' && !link.closest('#touches');
    if (isFar) byId('listing')?.closest('.card')?.scrollIntoView({ block: 'nearest' });
  });
}

/** @param {Choice} choice */
function followSize(choice) {
  let timer = 0;
  let width = document.documentElement.clientWidth;
  addEventListener('resize', () => {
    if (document.documentElement.dataset.paper != null) return;
    clearTimeout(timer);
    timer = window.setTimeout(() => {
      if (document.documentElement.clientWidth === width) return; // a bar of the browser came or went
      width = document.documentElement.clientWidth;
      choice.tell('size');
    }, RESIZE_REST);
  });
}

/** @param {import('./types').RunDocument} document_ @param {import('./types').Figures} figures */
function start(document_, figures) {
  const run = new Run(named(figures.run ?? document_, figures), figures);
  const { compare } = figures;
  // Both runs are shown in the frame of this one: what lies at one place in the machine lies at one on the page.
  const other = compare ? new Run(compare.document, { ...compare.figures, frame: figures.frame, probe: figures.probe }) : null;
  const parts = partsOf(figures);
  const choice = new Choice(run);
  const listing = new Listing(choice);
  const table = new TouchTable(choice, parts);
  const plan = new Plan(choice, parts, other);
  const scene = new Scene(choice, parts, other);
  const timeline = new Timeline(choice, other);
  const transport = new Transport(choice, (file, line) => listing.textOf(file, line));
  transport.show();
  drawLegends(other, parts.some((part) => apexOf(part, run) != null), timeline.goesBeyond);
  linkEverything(choice, listing);
  linkTheme(() => choice.tell('theme'));
  followSize(choice);
  followEditions(choice);
  keepPrintable({ plan, scene, timeline, listing, table });
  setTimeout(() => {
    scene.start();
    Object.assign(window.g31Timing ?? {}, { scene: performance.now() });
  });
}

function begin() {
  const began = performance.now();
  markOverflow();
  const document_ = jsonOf('g31-document');
  if (!document_) return;
  window.g31 = document_;
  restoreTheme();
  const figures = jsonOf('g31-figures') ?? {};
  useWords(figures.words);
  linkCopy();
  byId('print')?.addEventListener('click', () => print());
  start(document_, figures);
  window.g31Timing = { ready: performance.now(), script: performance.now() - began };
}

begin();
