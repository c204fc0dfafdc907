// A list too long to be written out: rows of one height, of which those in sight are there.

const BEYOND = 20; // rows above and below what is seen, so that scrolling does not show gaps

export class VirtualRows {
  /**
   * @param {HTMLElement} scroller scrolls the rows
   * @param {HTMLElement} holder <ol> or <tbody>
   * @param {number} count
   * @param {(index: number) => string} row its markup, from 0
   */
  constructor(scroller, holder, count, row) {
    this.scroller = scroller;
    this.holder = holder;
    this.count = count;
    this.row = row;
    this.first = 0;
    this.behind = -1;
    this.height = 0;
    scroller.addEventListener('scroll', () => this.show(), { passive: true });
  }

  /** The height of a row, from one that is shown. */
  measure() {
    if (this.height > 0) return;
    this.holder.innerHTML = this.row(0);
    const height = this.holder.firstElementChild?.getBoundingClientRect().height ?? 0;
    this.height = height > 0 ? height : 0;
  }

  /** Fills what is in sight. @param {boolean} [anew] also what is there already */
  show(anew = false) {
    this.measure();
    if (!this.height) return;
    const top = this.scroller.scrollTop - this.lead();
    const first = Math.max(0, Math.floor(top / this.height) - BEYOND);
    const behind = Math.min(this.count, Math.ceil((top + this.scroller.clientHeight) / this.height) + BEYOND);
    if (!anew && first === this.first && behind === this.behind) return;
    this.first = Math.min(first, this.count);
    this.behind = Math.max(behind, this.first);
    const rows = [];
    for (let index = this.first; index < this.behind; ++index) rows.push(this.row(index));
    this.holder.innerHTML = this.space(this.first) + rows.join('') + this.space(this.count - this.behind);
  }

  /** Where the rows begin within what scrolls. */
  lead() {
    const holder = this.holder.getBoundingClientRect();
    return holder.top - this.scroller.getBoundingClientRect().top + this.scroller.scrollTop;
  }

  /** @param {number} rows that are not there */
  space(rows) {
    const height = rows * this.height;
    return this.holder.tagName === 'TBODY'
      ? `<tr class="space" aria-hidden="true"><td style="height:${height}px"></td></tr>`
      : `<li class="space" aria-hidden="true" style="height:${height}px"></li>`;
  }

  /** Brings a row into sight. @param {number} index */
  reveal(index) {
    this.measure();
    const top = this.lead() + index * this.height;
    const { scrollTop, clientHeight } = this.scroller;
    if (top < scrollTop + this.height || top > scrollTop + clientHeight - 2 * this.height) {
      this.scroller.scrollTop = top - clientHeight / 2;
    }
    this.show();
  }

  /** All of these rows, for paper. @param {number[]} indices @param {string} [note] what has been left out */
  fill(indices, note = '') {
    this.holder.innerHTML = indices.map(this.row).join('') + note;
    this.behind = -1;
  }
}
