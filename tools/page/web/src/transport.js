// Plays the run: buttons, the range, what the machine does now, keys.
import { byId, esc, num } from './markup.js';
import { word } from './words.js';

const PLAY = '<svg viewBox="0 0 16 16" aria-hidden="true"><path d="M3 1.5l11 6.5-11 6.5z"/></svg>';
const PAUSE = '<svg viewBox="0 0 16 16" aria-hidden="true"><path d="M3 2h4v12H3zM9 2h4v12H9z"/></svg>';
const AXES = ['X', 'Y', 'Z'];

export class Transport {
  /** @param {import('./choice').Choice} choice @param {(file: string, line: number) => string} lineText */
  constructor(choice, lineText) {
    this.choice = choice;
    this.lineText = lineText;
    this.range = /** @type {HTMLInputElement | null} */ (byId('timeline'));
    this.playing = false;
    this.shownAt = 0;
    byId('play')?.addEventListener('click', () => this.toggle());
    byId('prev')?.addEventListener('click', () => choice.step(-1));
    byId('next')?.addEventListener('click', () => choice.step(1));
    this.range?.addEventListener('input', () => {
      this.stop();
      choice.moveTo(Number(this.range?.value));
    });
    addEventListener('keydown', (event) => this.key(event));
    choice.listen(() => this.show());
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const target = /** @type {HTMLElement} */ (event.target);
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (target.matches?.('select, textarea, input:not([type=range]):not([type=checkbox])')) return;
    if (event.key === '[') this.choice.step(-1);
    else if (event.key === ']') this.choice.step(1);
    else if (event.key === ' ' && !target.closest?.('button, a, input[type=checkbox], [data-keeps-space]')) this.toggle();
    else return;
    event.preventDefault();
  }

  toggle() {
    if (this.playing) return this.stop();
    if (this.choice.time >= this.choice.run.duration - 0.01) this.choice.moveTo(0);
    this.playing = true;
    this.shownAt = performance.now();
    this.showButton();
    requestAnimationFrame((now) => this.tick(now));
  }

  stop() {
    this.playing = false;
    this.showButton();
  }

  /** @param {number} now ms */
  tick(now) {
    if (!this.playing) return;
    const rate = Number(/** @type {HTMLSelectElement | null} */ (byId('rate'))?.value ?? 1);
    const seconds = Math.max(0, now - this.shownAt) / 1000;
    this.shownAt = now;
    this.choice.moveTo(this.choice.time + seconds * rate);
    if (this.choice.time >= this.choice.run.duration) return this.stop();
    requestAnimationFrame((next) => this.tick(next));
  }

  showButton() {
    const button = byId('play');
    if (!button) return;
    button.innerHTML = this.playing ? PAUSE : PLAY;
    button.setAttribute('aria-label', word(this.playing ? 'pause' : 'play'));
  }

  show() {
    const { run, time, contact } = this.choice;
    const kind = run.kindAt(time);
    const place = run.placeAt(time, contact);
    const at = contact && Math.abs(contact.time - time) < 1e-6 ? contact : null;
    const file = place?.file ?? '';
    const line = place?.line ?? 0;
    if (this.range) {
      this.range.value = String(time);
      const values = { time: num(time, 2), kind: word(kind), file, line };
      this.range.setAttribute('aria-valuetext', word(file ? 'now_aria' : 'now_aria_unplaced', values));
    }
    const now = byId('now');
    if (!now) return;
    const ball = run.ballAt(time);
    const work = at ? at.touch.work : ball?.map((value, axis) => value - run.frame.origin[axis]);
    const axes = work ? AXES.map((name, axis) => `${name} ${num(work[axis])}`).join(' &nbsp;') : '';
    now.innerHTML = `<b class="clock">${num(time)} s</b><span class="mut state-now">`
      + `${esc(at ? word('touch', { n: at.number }) : word(kind))}</span><span>${at ? esc(word('latched')) : ''}${axes}</span>`
      + (file ? `<code>${esc(file)}:${line} &nbsp;${esc(this.lineText(file, line).trim().slice(0, 200))}</code>` : '');
  }
}
