// The plan view: outline of a part at the height of its touches, touches with magnified deviations, the playing ball.
import { byId, clamp, decimalsOf, esc, niceStep, num } from './markup.js';
import { drawApproaches } from './plan_approaches.js';
import { planKeys } from './plan_keys.js';
import { flat, height, planeOf, planesOf } from './plan_planes.js';
import { PlanView } from './plan_view.js';
import { whiskersOf } from './plan_whiskers.js';
import { drawCrash, drawOrigin, measuredOf } from './plan_places.js';
import { hasZones, zonesOf } from './plan_zones.js';
import { word } from './words.js';

export class Plan {
  /** @param {import('./choice').Choice} choice @param {import('./types').Part[]} parts
   * @param {import('./run').Run | null} other */
  constructor(choice, parts, other) {
    this.choice = choice;
    this.other = other;
    this.box = byId('plan');
    const { run } = choice;
    const named = new Set(run.hits.map(({ touch }) => touch.part));
    if (run.collision) named.add(run.collision.part);
    this.parts = parts.filter((part) => named.has(part.name));
    /** @type {Map<string, PlanView>} */
    this.views = new Map();
    this.part = this.parts.find((part) => part.name === (run.collision?.part ?? choice.contact?.touch.part)) ?? this.parts[0];
    /** @type {Map<string, import('./plan_planes').Plane>} chosen */
    this.planes = new Map();
    this.choices = new Map(this.parts.map((part) => [part, planesOf(part)]));
    if (!this.box) return;
    byId('planhead')?.addEventListener('click', (event) => this.clicked(/** @type {HTMLElement} */ (event.target)));
    choice.listen((change) => this.hear(change));
    this.draw();
  }

  /** @param {import('./choice').Change} change */
  hear(change) {
    if (change === 'time') return this.moveBall();
    if (change === 'touch') {
      const part = this.parts.find((each) => each.name === this.choice.contact?.touch.part);
      if (part) this.part = part;
    }
    if (change !== 'theme') this.draw();
  }

  /** @param {HTMLElement} target */
  clicked(target) {
    const button = /** @type {HTMLElement | null} */ (target.closest('button'));
    if (!button) return;
    const { part, plane } = button.dataset;
    if (part != null) this.part = this.parts[Number(part)];
    if (plane != null) this.planes.set(this.part.name, this.choicesNow()[Number(plane)]);
    this.draw();
    const kept = part != null ? `[data-part="${part}"]` : `[data-plane="${plane}"]`;
    /** @type {HTMLElement | null | undefined} */ (byId('planhead')?.querySelector(`button${kept}`))?.focus();
  }

  choicesNow() {
    return this.choices.get(this.part) ?? [];
  }

  plane() {
    const known = this.planes.get(this.part.name);
    if (known) return known;
    const { run } = this.choice;
    const plane = planeOf(run.hits.filter(({ touch }) => touch.part === this.part.name), this.choicesNow());
    this.planes.set(this.part.name, plane);
    return plane;
  }

  view() {
    const plane = this.plane();
    const key = `${this.part.name} ${plane.name}`;
    const view = this.views.get(key) ?? new PlanView(this.choice.run, this.part, plane);
    this.views.set(key, view);
    return view;
  }

  /** @param {number} [wanted] px; the width of the box unless told @param {number} [share] height of the width */
  draw(wanted, share = 0.82) {
    if (!this.box) return;
    if (!this.part) {
      this.box.innerHTML = `<p class="limits">${esc(word('plan_empty'))}</p>`;
      return;
    }
    const width = wanted ?? Math.max(260, Math.round(this.box.clientWidth || 600));
    const view = this.view();
    const page = new Sheet(view, width, clamp(width * share, 300, 540));
    const { touch } = this.choice;
    const drawing = [this.material(view, page), page.rulers(), zonesOf(view, page), measuredOf(view, page), drawOrigin(view, page),
      this.ghost(view, page), view.crash ? '' : drawApproaches(view, page), whiskersOf(view, page, touch), view.crash ? drawCrash(view, page) : '',
      this.ball(page), page.scales()].join('');
    const label = esc(word('plan_aria', { part: this.part.name }));
    this.box.innerHTML = `<svg class="fig" viewBox="0 0 ${page.width} ${page.height}" role="img" aria-label="${label}">${drawing}</svg>`;
    this.page = page;
    this.head(view);
    const caption = byId('plancap');
    if (caption) caption.innerHTML = planKeys(view, this.other != null, hasZones(view));
    this.moveBall();
  }

  /** @param {PlanView} view @param {Sheet} page */
  material(view, page) {
    const d = view.walls.map(({ outline }) => `${page.path(outline)}z`).join('');
    return `<path d="${d}" fill="var(--mat)" fill-rule="evenodd" stroke="var(--ink)" stroke-width="1.4" stroke-linejoin="round"/>`;
  }

  /** Contacts of the other run on this part. @param {PlanView} view @param {Sheet} page */
  ghost(view, page) {
    if (!this.other) return '';
    const seen = new Set();
    return this.other.hits.filter(({ touch }) => touch.part === view.part.name).map(({ ball, radius }) => {
      const [x, y] = ball ? page.at(flat(ball, view.plane)) : [NaN, NaN];
      const key = `${Math.round(x)} ${Math.round(y)}`;
      if (!Number.isFinite(x) || seen.has(key)) return '';
      seen.add(key);
      return `<circle class="ghost" cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${Math.max(3, radius * page.scale).toFixed(1)}" `
        + 'fill="none" stroke="var(--accent)" stroke-width="1.3" stroke-dasharray="4 3"/>';
    }).join('');
  }

  /** @param {Sheet} page */
  ball(page) {
    const { probe } = this.choice.run.figures;
    const radii = [(probe?.ball ?? 0) / 2, ...(probe?.further ?? []).map(({ diameter }) => diameter / 2)];
    return radii.map((radius, n) => `<circle ${n ? '' : 'id="pball" '}class="pball" r="${Math.max(2.5, radius * page.scale).toFixed(1)}" `
      + 'fill="var(--skip)" fill-opacity=".18" stroke="var(--skip)" stroke-width="1.8"/>').join('');
  }

  moveBall() {
    const { page } = this;
    const circles = this.box?.querySelectorAll('.pball');
    if (!circles?.length || !page) return;
    this.choice.run.ballsAt(this.choice.time).forEach(({ at }, n) => {
      const [x, y] = page.at(flat(at, page.view.plane));
      circles[n].setAttribute('cx', x.toFixed(2));
      circles[n].setAttribute('cy', y.toFixed(2));
    });
  }

  /** @param {PlanView} view */
  head(view) {
    const head = byId('planhead');
    if (!head) return;
    const planes = this.choicesNow();
    const size = view.magnification ? word('plan_magnified', { mag: view.magnification }) : word('plan_true_size');
    const { axis } = view.plane;
    const above = num(view.height - height(view.from.origin, view.plane), 1);
    const choose = (/** @type {string} */ label, /** @type {string} */ name, /** @type {string[]} */ items, /** @type {number} */ on) =>
      `<span class="seg noprint" role="group" aria-label="${esc(label)}">${items.map((item, n) => `<button data-${name}="${n}" `
        + `aria-pressed="${n === on}">${esc(item)}</button>`).join('')}</span>`;
    const parts = this.parts.length > 1
      ? choose(word('plan_part'), 'part', this.parts.map((part) => part.name), this.parts.indexOf(this.part)) : '';
    head.innerHTML = `<h2>${esc(word('plan_view'))}</h2><span class="sub">${esc(this.part.name)}, ${esc(view.from.name)}, `
      + `${esc(word('section_at', { axis, height: above }))}; ${esc(size)}</span><span class="right">${parts}`
      + `${choose(word('plan_plane'), 'plane', planes.map(({ name }) => name), planes.indexOf(view.plane))}</span>`;
  }
}

/** The paper of a plan view: mm of its plane to px. */
export class Sheet {
  /** @param {PlanView} view @param {number} width @param {number} height */
  constructor(view, width, height) {
    this.view = view;
    this.width = width;
    this.height = height;
    this.scale = Math.min(width - 8, height) / (2 * view.frame.half);
  }

  /** @param {import('./section').Flat} point @returns {import('./section').Flat} */
  at([u, v]) {
    return [this.width / 2 + (u - this.view.frame.u) * this.scale, this.height / 2 - 2 - (v - this.view.frame.v) * this.scale];
  }

  /** @param {import('./section').Flat[]} points */
  path(points) {
    return points.map((point, n) => (n ? 'L' : 'M') + this.at(point).map((px) => px.toFixed(2)).join(' ')).join('');
  }

  /** @param {import('./section').Flat} from @param {import('./section').Flat} to @param {string} ink @param {number} [width] */
  arrow(from, to, ink, width = 1.6) {
    const [x1, y1] = this.at(from);
    const [x2, y2] = this.at(to);
    const angle = Math.atan2(y2 - y1, x2 - x1);
    const barb = (/** @type {number} */ turn) => `${(x2 - 5.5 * Math.cos(angle + turn)).toFixed(1)} ${(y2 - 5.5 * Math.sin(angle + turn)).toFixed(1)}`;
    return `<path d="M${x1.toFixed(1)} ${y1.toFixed(1)}L${x2.toFixed(1)} ${y2.toFixed(1)}M${barb(-0.45)}L${x2.toFixed(1)} ${y2.toFixed(1)}`
      + `L${barb(0.45)}" fill="none" stroke="${ink}" stroke-width="${width}"/>`;
  }

  /** Ticks of both axes along the edges, in the frame that is shown. */
  rulers() {
    const { plane, from } = this.view;
    const origin = flat(from.origin, plane);
    const step = niceStep(62 / this.scale);
    const decimals = decimalsOf(step);
    let ticks = '';
    let texts = '';
    const axisTicks = (/** @type {boolean} */ across) => {
      const zero = origin[across ? 0 : 1];
      const middle = (across ? this.view.frame.u : this.view.frame.v) - zero;
      const reach = (across ? this.width : this.height) / 2 / this.scale;
      for (let n = Math.ceil((middle - reach) / step * 2); n <= ((middle + reach) / step) * 2; ++n) {
        const value = (n * step) / 2;
        const [x, y] = this.at(across ? [zero + value, 0] : [0, zero + value]);
        const long = n % 2 === 0;
        if (across && x > 8 && x < this.width - 8) ticks += `M${x.toFixed(1)} ${this.height - 1}v${long ? -8 : -4}`;
        if (!across && y > 24 && y < this.height - 20) ticks += `M1 ${y.toFixed(1)}h${long ? 8 : 4}`;
        if (!long) continue;
        if (across && x > 30 && x < this.width - 58) {
          texts += `<text x="${x.toFixed(1)}" y="${this.height - 12}" text-anchor="middle" class="halo">${num(value, decimals)}</text>`;
        } else if (!across && y > 32 && y < this.height - 28) {
          texts += `<text x="12" y="${(y + 3.5).toFixed(1)}" class="halo">${num(value, decimals)}</text>`;
        }
      }
    };
    axisTicks(true);
    axisTicks(false);
    return `<path d="${ticks}" stroke="var(--line2)"/><g font-size="10.5" fill="var(--ink3)">${texts}</g>`
      + `<g font-size="11" fill="var(--ink2)"><text x="12" y="18" class="halo">${plane.name[1]} mm</text>`
      + `<text x="${this.width - 12}" y="${this.height - 12}" text-anchor="end" class="halo">${plane.name[0]} mm</text></g>`;
  }

  /** Bars of true and of magnified lengths, in their own inks. */
  scales() {
    const [right, low] = [this.width - 16, this.height - 32];
    const step = niceStep(26 / this.scale);
    const bar = (step * this.scale).toFixed(1);
    let drawn = `<path d="M${right - Number(bar)} ${low}v-5m0 5h${bar}m0 0v-5" fill="none" stroke="var(--ink2)"/>`
      + `<text x="${right}" y="${low - 8}" font-size="11" fill="var(--ink2)" text-anchor="end" class="halo">${num(step, decimalsOf(step))} mm</text>`;
    if (this.view.magnification) {
      const perMicron = (this.scale * this.view.magnification) / 1000;
      const microns = niceStep(26 / perMicron);
      const long = microns * perMicron;
      drawn += `<path d="M${right - long} ${low - 32}h${long.toFixed(1)}" stroke="var(--accent)" stroke-width="5"/>`
        + `<text x="${right}" y="${low - 40}" font-size="11" fill="var(--ink2)" text-anchor="end" class="halo">${num(microns, decimalsOf(microns))} µm</text>`;
    }
    return drawn;
  }
}
