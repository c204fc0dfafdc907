// The time line: touches, calls as a flame, bands of motion, axis positions, the playhead; scrubbing.
import { byId, clamp, decimalsOf, decimalsWithin, esc, mark, markHalf, niceStep, num } from './markup.js';
import { drawnCurve, levelOf } from './timeline_curves.js';
import { bandsOf, curvesOf, marksOf, rangesOf, spansOf } from './timeline_layers.js';
import { word } from './words.js';

const RIGHT = 14;
const TOP = 34;
const LEVEL = 20;
const CURVE = 44;
const NARROW = 560;
const WORDS = 15; // px above the marks, for what a collision says
const LABEL = 0.005; // of a scale: so well its ends are told
const CALL_INKS = ['var(--mat2)', 'var(--mat3)'];
const HEIGHTS = { rapid: [4, 4], feed: [2, 8], skip: [0, 12] };

export class Timeline {
  /** @param {import('./choice').Choice} choice @param {import('./run').Run | null} other */
  constructor(choice, other) {
    this.choice = choice;
    this.other = other;
    this.box = byId('chart');
    this.width = 0;
    this.goesBeyond = false;
    if (!this.box) return;
    if (!(choice.run.duration > 0)) {
      this.box.innerHTML = `<p class="limits">${esc(word('timeline_empty'))}</p>`;
      return;
    }
    this.ranges = rangesOf(choice.run);
    let scrubs = false;
    this.box.addEventListener('pointerdown', (event) => {
      if (/** @type {Element} */ (event.target).closest('[data-t], [data-go]')) return;
      scrubs = true;
      this.scrub(event);
    });
    addEventListener('pointermove', (event) => scrubs && this.scrub(event));
    addEventListener('pointerup', () => { scrubs = false; });
    choice.listen((change) => (change === 'time' ? this.moveCursor() : this.draw()));
    this.draw();
  }

  /** @param {PointerEvent} event */
  scrub(event) {
    const drawing = this.box?.querySelector('svg');
    if (!drawing) return;
    const { left, width } = drawing.getBoundingClientRect();
    const x = ((event.clientX - left) * this.width) / width;
    this.choice.moveTo(clamp((x - this.gutter()) / (this.width - this.gutter() - RIGHT), 0, 1) * this.choice.run.duration);
  }

  gutter() {
    return this.width < NARROW ? 34 : 86;
  }

  /** @param {number} time s */
  x(time) {
    const { duration } = this.choice.run;
    return this.gutter() + (time / duration) * (this.width - this.gutter() - RIGHT);
  }

  /** @param {number} [width] px; that of its box unless told */
  draw(width) {
    if (!this.box || !this.ranges) return;
    this.width = width ?? Math.max(260, Math.round(this.box.clientWidth || 600));
    const { run } = this.choice;
    const spans = spansOf(run, (time) => this.x(time));
    const depth = Math.max(1, ...spans.map((span) => span.level + 1));
    const motion = TOP + depth * LEVEL + 6;
    const curves = motion + LEVEL;
    const height = curves + 3 * CURVE + 26;
    const parts = [this.grid(height), this.touches(height), this.calls(spans), this.motion(motion), this.positions(curves),
      this.marks(), this.collision(height), cursor(height)];
    const label = word('timeline_aria', { time: num(run.duration, 1) });
    const above = run.collision ? WORDS : 0;
    this.box.innerHTML = `<svg class="fig" viewBox="0 ${-above} ${this.width} ${height + above}" role="img" aria-label="${esc(label)}" `
      + `style="cursor:col-resize">${parts.join('')}</svg>`;
    this.moveCursor();
  }

  moveCursor() {
    this.box?.querySelector('#cursor')?.setAttribute('transform', `translate(${this.x(this.choice.time).toFixed(2)} 0)`);
  }

  /** @param {string} text @param {number} y */
  label(text, y) {
    const shown = this.width < NARROW ? text.slice(0, 1) : text;
    return `<text x="${this.gutter() - 10}" y="${y}" font-size="11.5" fill="var(--ink2)" text-anchor="end">${esc(shown)}</text>`;
  }

  /** @param {number} height */
  grid(height) {
    const { duration } = this.choice.run;
    const step = niceStep((duration * 46) / (this.width - this.gutter()));
    const decimals = decimalsOf(step);
    let lines = '';
    let texts = '';
    for (let n = 0; n * step <= duration + 1e-9; ++n) {
      const x = this.x(n * step).toFixed(1);
      lines += `M${x} 30V${height - 20}`;
      texts += `<text x="${x}" y="${height - 6}" font-size="10.5" fill="var(--ink3)" text-anchor="middle">`
        + `${num(n * step, decimals)}${(n + 1) * step > duration + 1e-9 ? ' s' : ''}</text>`;
    }
    return `<path d="${lines}" stroke="var(--line)"/>${texts}`;
  }

  /** Lines of the touches through all layers, and the shade of the skip moves. @param {number} height */
  touches(height) {
    const { run } = this.choice;
    const shades = bandsOf(run, (time) => this.x(time)).skip;
    const shade = shades.map(([a, b]) => `M${a.toFixed(1)} 30H${b.toFixed(1)}V${height - 20}H${a.toFixed(1)}z`).join('');
    const thin = { counts: '', rest: '', missed: '' };
    let last = { counts: -9, rest: -9, missed: -9 };
    for (const contact of run.contacts) {
      const x = this.x(contact.time);
      const kind = !contact.hit ? 'missed' : contact.counts ? 'counts' : 'rest';
      if (x - last[kind] < 1) continue; // marks of one pixel are one mark
      last[kind] = x;
      thin[kind] += contact.hit ? `M${x.toFixed(1)} 26V${height - 20}` : `M${x.toFixed(1)} 24v6`;
    }
    return `<path d="${shade}" fill="var(--skip)" opacity=".07"/><path d="${thin.missed}" stroke="var(--ink3)"/>`
      + `<path d="${thin.rest}" stroke="var(--ink)" stroke-width=".6" opacity=".45"/>`
      + `<path d="${thin.counts}" stroke="var(--ink)" stroke-width="1.1" opacity=".75"/>${this.ghostTouches(height)}`
      + this.label(word('timeline_touches'), 22);
  }

  /** @param {number} height */
  ghostTouches(height) {
    if (!this.other) return '';
    let lines = '';
    let last = -9;
    for (const { time } of this.other.hits) {
      const x = this.x(time);
      if (x - last < 2 || time > this.choice.run.duration) continue;
      last = x;
      lines += `M${x.toFixed(1)} 26V${height - 20}`;
    }
    return `<path class="ghost" d="${lines}" stroke="var(--accent)" stroke-width="1" stroke-dasharray="3 3" opacity=".7"/>`;
  }

  marks() {
    const half = markHalf(this.choice.run.contacts.length); // of the longest number
    const gap = Math.max(this.width < NARROW ? 21 : 20, 2 * half + 1);
    const placed = marksOf(this.choice, (time) => this.x(time), gap, this.width - half - 2);
    const chosen = placed.filter((each) => each.contact.number === this.choice.touch);
    const rest = placed.filter((each) => each.contact.number !== this.choice.touch);
    return [...rest, ...chosen].map(({ contact, x }) => mark(contact, x, 14, contact.number === this.choice.touch)).join('');
  }

  /** @param {ReturnType<typeof spansOf>} spans */
  calls(spans) {
    return this.label(word('timeline_calls'), TOP + 13) + spans.map(({ span, level, from, width }) => {
      const y = TOP + level * LEVEL;
      const room = Math.floor((width - 10) / 7);
      const name = room < 3 ? '' : span.program.length <= room ? span.program : `${span.program.slice(0, room - 1)}…`;
      const text = name ? `<text x="${(from + 5).toFixed(1)}" y="${y + 13}" font-size="11" fill="var(--ink)">${esc(name)}</text>` : '';
      const go = span.file && span.line ? ` data-go="${esc(span.file)}:${span.line}" style="cursor:pointer"` : '';
      return `<g${go}><title>${esc(span.program)}</title><rect x="${from.toFixed(1)}" y="${y}" width="${width.toFixed(1)}" `
        + `height="18" fill="${CALL_INKS[level % 2]}" rx="1.5"/>${text}</g>`;
    }).join('');
  }

  /** @param {number} y */
  motion(y) {
    const bands = bandsOf(this.choice.run, (time) => this.x(time));
    const paths = /** @type {import('./types').Kind[]} */ (['rapid', 'feed', 'skip']).map((kind) => {
      const [offset, height] = HEIGHTS[kind];
      const d = bands[kind].map(([a, b]) => `M${a.toFixed(1)} ${y + offset}H${b.toFixed(1)}v${height}H${a.toFixed(1)}z`).join('');
      return `<path class="band ${kind}" d="${d}" fill="var(--${kind})"/>`;
    });
    return this.label(word('timeline_motion'), y + 10) + paths.join('');
  }

  /** @param {number} y0 */
  positions(y0) {
    const ranges = /** @type {[number, number][]} */ (this.ranges);
    const x = (/** @type {number} */ time) => this.x(time);
    const own = curvesOf(this.choice.run, x);
    const ghost = this.other?.hasTimes ? curvesOf(this.other, x) : null;
    return ['X', 'Y', 'Z'].map((name, axis) => {
      const top = y0 + axis * CURVE;
      const [low, high] = ranges[axis];
      const shown = (/** @type {[number, number][]} */ points) => drawnCurve(points.filter((p) => p[0] <= this.width - RIGHT + 0.5), ranges[axis], top);
      const curve = shown(own[axis]);
      this.goesBeyond ||= curve.arrows !== '';
      const ends = this.width < NARROW ? '' : [[high, 11], [low, 40]].map(([value, dy]) => `<text x="${this.gutter() - 26}" `
        + `y="${top + dy}" font-size="10" fill="var(--ink3)" text-anchor="end">${num(value, decimalsWithin(value, LABEL * (high - low)))}</text>`).join('');
      const zero = low < 0 && high > 0
        ? `<path d="M${this.gutter()} ${levelOf(0, ranges[axis], top).toFixed(1)}H${this.width - RIGHT}" stroke="var(--line2)" stroke-dasharray="2 3"/>` : '';
      return `<path d="M${this.gutter()} ${top + 42}H${this.width - RIGHT}" stroke="var(--line)"/>${zero}`
        + `${this.label(name, top + 24)}${ends}`
        + (ghost ? `<path class="ghost" d="${shown(ghost[axis]).line}" fill="none" stroke="var(--accent)" stroke-width="1.3" stroke-dasharray="4 3"/>` : '')
        + `<path d="${curve.line}" fill="none" stroke="var(--ink)" stroke-width="1.3" stroke-linejoin="round"/>`
        + `<path d="${curve.dots}" stroke="var(--ink3)" stroke-dasharray="1.5 3"/><path class="beyond" d="${curve.arrows}" fill="var(--ink2)"/>`
        + `<g font-size="10" fill="var(--ink2)">${curve.values}</g>`;
    }).join('');
  }

  /** @param {number} height */
  collision(height) {
    const { run } = this.choice;
    if (!run.collision) return '';
    const x = this.x(run.duration);
    return `<path d="M${x} 26V${height - 20}" stroke="var(--bad)" stroke-width="2.5"/><text x="${x + 6}" y="${12 - WORDS}" font-size="12" `
      + `font-weight="600" class="halo" fill="var(--bad)" text-anchor="end">${esc(word('collision_at', { time: num(run.duration) }))}</text>`;
  }
}

/** @param {number} height */
function cursor(height) {
  return `<g id="cursor"><path d="M0 27V${height - 18}" stroke="var(--accent)" stroke-width="2"/>`
    + `<path d="M-5 ${height - 13}h10l-5-7z" fill="var(--accent)"/></g>`;
}
