// Playhead and chosen touch: two things, for scrubbing leaves the chosen touch marked.

/** @typedef {'time' | 'touch' | 'size' | 'theme'} Change */

export class Choice {
  /** @param {import('./run').Run} run */
  constructor(run) {
    this.run = run;
    this.time = run.collision || !run.hits.length ? run.duration : run.hits[run.hits.length - 1].time;
    /** @type {number | null} */
    this.touch = run.collision || !run.hits.length ? null : run.hits[run.hits.length - 1].number;
    /** @type {((change: Change) => void)[]} */
    this.listeners = [];
  }

  /** @param {(change: Change) => void} listener */
  listen(listener) {
    this.listeners.push(listener);
  }

  /** @param {Change} change */
  tell(change) {
    for (const listener of this.listeners) listener(change);
  }

  get contact() {
    return this.touch == null ? null : this.run.contact(this.touch);
  }

  /** @param {number} time s */
  moveTo(time) {
    this.time = Math.max(0, Math.min(this.run.duration, time));
    this.tell('time');
  }

  /** Chooses a touch; the playhead goes there. @param {number} number from 1 */
  choose(number) {
    const contact = this.run.contact(number);
    if (!contact) return;
    this.touch = number;
    this.time = Math.min(contact.time, this.run.duration);
    this.tell('touch');
  }

  /** The touch with a signal before or behind the chosen one, in a ring. @param {1 | -1} way */
  step(way) {
    const { hits } = this.run;
    if (!hits.length) return;
    const here = hits.findIndex((contact) => contact.number === this.touch);
    if (here >= 0) return this.choose(hits[(here + way + hits.length) % hits.length].number);
    const next = hits.findIndex((contact) => contact.time > this.time + 1e-6);
    const behind = next < 0 ? hits.length : next;
    this.choose(hits[(way > 0 ? behind : behind - 1 + hits.length) % hits.length].number);
  }
}
