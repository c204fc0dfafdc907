// The table of touches: the chosen row, rows without a signal folded away, rows of a long run as they come in sight.
import { byId, esc, num, um } from './markup.js';
import { turnedBack } from './turn.js';
import { VirtualRows } from './virtual_rows.js';
import { word } from './words.js';

const FOLDED_PAST = 16; // rows
const IN_PRINT = 5000; // rows
const STEEP = 30; // degrees between the move and the normal

export class TouchTable {
  /** @param {import('./choice').Choice} choice @param {import('./types').Part[]} parts */
  constructor(choice, parts) {
    this.choice = choice;
    this.parts = new Map(parts.map((part) => [part.name, part]));
    this.table = byId('touches');
    this.all = /** @type {HTMLInputElement | null} */ (byId('allt'));
    /** @type {VirtualRows | null} */
    this.rows = null;
    /** @type {import('./types').Contact[]} */
    this.listed = [];
    if (!this.table) return;
    const body = /** @type {HTMLElement | null} */ (this.table.querySelector('tbody[data-virtual]'));
    const box = this.table.parentElement;
    if (body && box) this.makeVirtual(body, box);
    this.all?.addEventListener('change', () => this.fold());
    this.table.addEventListener('click', (event) => {
      const target = /** @type {HTMLElement} */ (event.target);
      const row = /** @type {HTMLElement | null} */ (target.closest('tr[data-touch]'));
      if (row && !target.closest('a, [data-t]')) choice.choose(Number(row.dataset.touch));
    });
    this.fold();
    choice.listen((change) => {
      if (change === 'touch') this.mark();
      else if (change === 'size') this.rows?.show();
    });
    this.mark();
  }

  /** @param {HTMLElement} body @param {HTMLElement} box */
  makeVirtual(body, box) {
    this.rows = new VirtualRows(box, body, 0, (index) => this.row(this.listed[index]));
  }

  fold() {
    const { contacts, hits } = this.choice.run;
    const folds = this.all ? !this.all.checked : contacts.length > FOLDED_PAST && this.rows != null;
    this.table?.classList.toggle('few', folds && this.all != null);
    if (!this.rows) return;
    this.listed = folds ? hits : contacts;
    this.rows.count = this.listed.length;
    this.rows.show(true);
  }

  mark() {
    const { touch } = this.choice;
    if (!this.table) return;
    this.table.querySelector('tr.sel')?.classList.remove('sel');
    if (touch == null) return;
    const index = this.rows ? this.listed.findIndex((contact) => contact.number === touch) : -1;
    if (index >= 0) this.rows?.reveal(index);
    const row = this.table.querySelector(`tr[data-touch="${touch}"]`);
    row?.classList.add('sel');
    if (row && !this.rows) this.bringInSight(row);
  }

  /** Scrolls the rows, never the page. @param {Element} row */
  bringInSight(row) {
    const box = this.table?.parentElement;
    const head = this.table?.querySelector('thead')?.getBoundingClientRect().height ?? 0;
    if (!box) return;
    const top = row.getBoundingClientRect().top - box.getBoundingClientRect().top;
    if (top < head || top > box.clientHeight - 2 * head) box.scrollTop += top - box.clientHeight / 2;
  }

  /** The place of contact in the frame of its part. @param {import('./types').Contact} contact */
  onPart({ touch, place }) {
    const part = this.parts.get(touch.part ?? '');
    return part && place ? turnedBack(place.map((value, axis) => value - part.origin[axis]), part.turn) : null;
  }

  /** @param {import('./types').Contact} contact */
  row(contact) {
    const { touch, number } = contact;
    const place = `${esc(touch.file)}:${touch.line}`;
    const cells = (/** @type {number[] | null} */ point, decimals = 3) => (point
      ? point.slice(0, 3).map((value) => `<td class="n">${num(value, decimals)}</td>`).join('')
      : '<td class="n mut">–</td>'.repeat(3));
    // Work coordinates differ from machine coordinates by what they differ by at the latched place.
    const commanded = touch.commanded.slice(0, 3).map((value, axis) => value - touch.latched[axis] + touch.work[axis]);
    const steep = (contact.angle ?? 0) > STEEP;
    const chosen = this.choice.touch === number ? ' sel' : '';
    return `<tr data-touch="${number}" class="${contact.hit ? '' : 'un'}${chosen}"><td class="stick">`
      + `<button class="badge${contact.counts ? '' : ' f'}" data-t="${number}" aria-label="${esc(word('touch_button', { n: number }))}">`
      + `${number}</button></td><td><a href="#L-${place.replace(':', '-')}" data-go="${place}">${place}</a> `
      + `<span class="mut">${esc(touch.block)}</span></td><td class="n">${num(contact.time)}</td><td class="n">${num(touch.feed, 0)}</td>`
      + `${cells(commanded)}${cells(touch.triggered ? touch.work : null, 4)}<td>${esc(touch.part ?? '–')}</td>`
      + `${cells(this.onPart(contact), 4)}<td class="n"><b>${um(contact.deviation)}</b></td>`
      + `<td class="n${steep ? ' no' : ''}">${num(contact.angle, 1)}</td><td>${esc(contact.role)}</td></tr>`;
  }

  /** All touches for paper; past 5,000 those with a signal. */
  beforePrint() {
    if (!this.rows) return;
    const { contacts, hits } = this.choice.run;
    this.listed = contacts.length <= IN_PRINT ? contacts : hits.slice(0, IN_PRINT);
    const values = { shown: this.listed.length, all: contacts.length, rule: word('rule_signal') };
    const note = this.listed.length < contacts.length
      ? `<tr class="left-out"><td colspan="17">${esc(word('rows_left_out', values))}</td></tr>` : '';
    this.rows.fill([...this.listed.keys()], note);
  }

  afterPrint() {
    this.fold();
  }
}
