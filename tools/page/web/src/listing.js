// The listing: one file in sight, counts at its lines, the line that runs now marked.
import { byId, esc } from './markup.js';
import { VirtualRows } from './virtual_rows.js';
import { word } from './words.js';

const BADGES = 6; // touch numbers at a line; more say how many more
const IN_PRINT = 5000; // rows

/** @typedef {{list: HTMLElement, rows: VirtualRows | null, lines: string[]}} Shown */

export class Listing {
  /** @param {import('./choice').Choice} choice */
  constructor(choice) {
    this.choice = choice;
    this.box = byId('listing');
    /** @type {Map<string, Shown>} */
    this.files = new Map();
    /** @type {Map<string, string[]>} */
    this.texts = new Map();
    for (const { file, text } of choice.run.figures.listing ?? []) this.texts.set(file, text.split(/\r?\n/));
    this.counts = new Map((choice.run.document.counts ?? []).map((each) => [each.file, each]));
    this.touchesOf = touchesByLine(choice.run);
    this.file = '';
    this.current = { file: '', line: 0 };
    for (const list of this.box?.querySelectorAll('ol') ?? []) this.add(list);
    byId('ltabs')?.addEventListener('click', (event) => {
      const name = /** @type {HTMLElement} */ (event.target).closest('button')?.dataset.file;
      if (name != null) this.open(name);
    });
    this.box?.addEventListener('click', (event) => this.clicked(/** @type {HTMLElement} */ (event.target)));
    this.follow();
    if (!this.file && this.files.size) this.open([...this.files.keys()][0]);
    choice.listen((change) => (change === 'size' ? this.shown()?.rows?.show() : this.follow()));
  }

  /** @param {HTMLElement} list an <ol data-file> */
  add(list) {
    const file = list.dataset.file ?? '';
    const lines = this.texts.get(file) ?? [];
    const isVirtual = list.dataset.virtual != null && this.box && lines.length > 0;
    const rows = isVirtual && this.box
      ? new VirtualRows(this.box, list, lines.length, (index) => this.row(file, lines[index], index + 1)) : null;
    this.files.set(file, { list, rows, lines });
    list.hidden = true;
  }

  shown() {
    return this.files.get(this.file);
  }

  /** @param {string} file @param {number} line from 1 */
  textOf(file, line) {
    return this.texts.get(file)?.[line - 1] ?? '';
  }

  /** Brings a file to the front. @param {string} file */
  open(file) {
    const shown = this.files.get(file);
    if (!shown || this.file === file) return;
    this.file = file;
    for (const [name, each] of this.files) each.list.hidden = name !== file;
    for (const tab of byId('ltabs')?.querySelectorAll('button') ?? []) {
      tab.setAttribute('aria-pressed', String(tab.dataset.file === file));
    }
    if (this.box) this.box.scrollTop = 0;
    shown.rows?.show(true);
  }

  /** Marks the line of the playhead. */
  follow() {
    const place = this.choice.run.placeAt(this.choice.time, this.choice.contact);
    if (place?.file && place.line) this.go(place.file, place.line);
  }

  /** @param {string} file @param {number} line from 1 */
  go(file, line) {
    const shown = this.files.get(file);
    if (!shown || !this.box) return;
    const same = this.current.file === file && this.current.line === line && this.file === file;
    this.open(file);
    if (same) return;
    this.box.querySelector('li.cur')?.classList.remove('cur');
    this.current = { file, line };
    if (shown.rows) {
      shown.rows.reveal(line - 1);
      shown.list.querySelector(`li[data-l="${line}"]`)?.classList.add('cur');
      return;
    }
    const row = document.getElementById(`L-${file}-${line}`);
    if (!row) return;
    row.classList.add('cur');
    const top = row.getBoundingClientRect().top - this.box.getBoundingClientRect().top;
    if (top < 30 || top > this.box.clientHeight - 50) this.box.scrollTop += top - this.box.clientHeight / 2;
  }

  /** A line shows when it ran: the next time behind the playhead, else the first. @param {HTMLElement} target */
  clicked(target) {
    const row = /** @type {HTMLElement | null} */ (target.closest('li[data-l]'));
    if (!row || target.closest('[data-t], a')) return;
    const line = Number(row.dataset.l);
    const { run, time } = this.choice;
    const moves = run.moves.filter((move) => move.line === line && move.file === this.file);
    const move = moves.find((each) => each.until > time + 1e-6) ?? moves[0];
    if (move) this.choice.moveTo(move.until);
  }

  /** Markup of a line that the command has not written. @param {string} file @param {string} text
   * @param {number} line from 1 */
  row(file, text, line) {
    const counted = this.counts.get(file);
    const count = counted?.lines[line];
    const condition = counted?.conditions?.[line];
    const oneWay = condition && (condition[0] === 0 || condition[1] === 0);
    const kind = count == null ? '' : count === 0 ? 'z' : oneWay ? 'p' : 'x';
    const numbers = this.touchesOf.get(`${file}:${line}`) ?? [];
    const badges = numbers.slice(0, BADGES).map((n) => `<span class="badge f" data-t="${n}">${n}</span>`).join('');
    const more = numbers.length > BADGES ? `<span class="mut">+${numbers.length - BADGES}</span>` : '';
    const current = this.current.file === file && this.current.line === line ? ' cur' : '';
    return `<li id="L-${esc(file)}-${line}" data-l="${line}" class="${kind}${current}"><span class="ct">${count ?? ''}</span>`
      + `<span class="no">${line}</span><span class="tx">${esc(text) || ' '}</span><span class="tb">${badges}${more}</span></li>`;
  }

  /** All lines for paper; past 5,000 those that ran. */
  beforePrint() {
    for (const [file, { rows, lines }] of this.files) {
      if (!rows) continue;
      const all = [...lines.keys()];
      const ran = this.counts.get(file)?.lines ?? {};
      const kept = all.length <= IN_PRINT ? all : all.filter((index) => ran[index + 1] > 0).slice(0, IN_PRINT);
      const values = { shown: kept.length, all: all.length, rule: word('rule_executed') };
      rows.fill(kept, kept.length < all.length ? `<li class="left-out">${esc(word('rows_left_out', values))}</li>` : '');
    }
    for (const { list } of this.files.values()) list.hidden = false;
  }

  afterPrint() {
    for (const [name, { list, rows }] of this.files) {
      list.hidden = name !== this.file;
      if (rows && name === this.file) rows.show(true);
      else if (rows) list.innerHTML = '';
    }
  }
}

/** Numbers of the touches with a signal at each line. @param {import('./run').Run} run */
function touchesByLine(run) {
  /** @type {Map<string, number[]>} */
  const numbers = new Map();
  for (const { number, touch } of run.hits) {
    const key = `${touch.file}:${touch.line}`;
    const here = numbers.get(key);
    if (here) here.push(number);
    else numbers.set(key, [number]);
  }
  return numbers;
}
