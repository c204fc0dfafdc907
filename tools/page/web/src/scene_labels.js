// Labels above the scene: numbers of touches, names of parts, axes; none covers another.
import { esc, num } from './markup.js';
import { word } from './words.js';

const LABELS = 48;
const WAYS_OUT = [[0, -26], [22, -18], [-22, -18], [30, 4], [-30, 4], [0, 28], [40, -30], [-40, -30], [0, -46], [48, -8], [-48, -8]];

/** @typedef {{x: number, y: number, w: number, h: number}} Rect */
/** @typedef {import('./orbit').Orbit} Orbit */

/** @param {Rect} a @param {Rect} b */
const overlap = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;

export class SceneLabels {
  /** @param {HTMLElement} box @param {import('./choice').Choice} choice @param {import('./scene_content').Solid[]} solids
   * @param {import('./types').Contact[]} places */
  constructor(box, choice, solids, places) {
    this.choice = choice;
    this.solids = solids;
    this.places = places;
    this.layer = document.createElement('div');
    this.layer.className = 'scene-labels';
    this.layer.setAttribute('aria-hidden', 'true'); // the same stands in the table of touches
    box.append(this.layer);
  }

  /** @param {Orbit} orbit @param {number} magnification */
  draw(orbit, magnification) {
    /** @type {Rect[]} */
    const taken = [{ x: orbit.width - 100, y: orbit.height - 84, w: 100, h: 84 }, { x: orbit.width - 240, y: 0, w: 240, h: 40 }];
    this.leaders = '';
    const html = this.touches(orbit, taken) + this.names(orbit, taken) + this.scale(orbit, magnification);
    this.layer.innerHTML = `<svg viewBox="0 0 ${orbit.width} ${orbit.height}">${this.leaders}${axesOf(orbit)}</svg>${html}`;
  }

  /** @param {Orbit} orbit @param {Rect[]} taken */
  touches(orbit, taken) {
    const { run, contact: chosen, touch } = this.choice;
    const rest = this.places.filter(({ number }) => number !== touch);
    const order = [...(chosen?.hit ? [chosen] : []), ...rest.filter(({ counts }) => counts), ...rest.filter(({ counts }) => !counts)];
    const shown = [];
    for (const contact of order) {
      if (shown.length >= LABELS) break;
      const label = contact.place ? this.numbered(orbit, contact, taken) : '';
      if (label) shown.push(label);
    }
    const crash = run.collision?.contact;
    if (crash) {
      const [x, y] = orbit.project(crash);
      this.leaders += `<path d="M${x - 7} ${y - 7}l14 14m0 -14l-14 14" stroke="var(--bad)" stroke-width="3"/>`;
    }
    return shown.join('');
  }

  /** @param {Orbit} orbit @param {import('./types').Contact} contact @param {Rect[]} taken */
  numbered(orbit, contact, taken) {
    const [x, y] = orbit.project(contact.place ?? []);
    if (x < 0 || y < 0 || x > orbit.width || y > orbit.height) return '';
    const wide = 16 + 7 * String(contact.number).length;
    for (const [dx, dy] of WAYS_OUT) {
      const box = { x: x + dx - wide / 2, y: y + dy - 11, w: wide, h: 22 };
      const inside = box.x > 2 && box.y > 2 && box.x + box.w < orbit.width - 2 && box.y + box.h < orbit.height - 2;
      if (!inside || taken.some((other) => overlap(other, box))) continue;
      taken.push(box);
      this.leaders += `<path d="M${x.toFixed(1)} ${y.toFixed(1)}L${(x + dx).toFixed(1)} ${(y + dy).toFixed(1)}" stroke="var(--ink3)" `
        + `stroke-width=".8"/><circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="3" fill="var(--ink)"/>`;
      const state = contact.number === this.choice.touch ? ' sel' : contact.counts ? '' : ' f';
      return `<span class="badge${state}" data-t="${contact.number}" style="${at(orbit, x + dx, y + dy)}">${contact.number}</span>`;
    }
    return '';
  }

  /** @param {Orbit} orbit @param {Rect[]} taken */
  names(orbit, taken) {
    return this.solids.map(({ part: { name, box } }) => {
      const foot = [...[0, 1].map((axis) => (box.low[axis] + box.high[axis]) / 2), box.low[2]];
      const reach = Math.max(box.high[0] - box.low[0], box.high[1] - box.low[1]) / 2;
      const [x, y] = orbit.project(foot.map((value, axis) => value + (axis < 2 ? orbit.eye[axis] * reach : 0)));
      const wide = 7.4 * name.length + 8;
      for (const dy of [14, 30, 46, -6, 62]) {
        const rect = { x: x - wide / 2, y: y + dy - 9, w: wide, h: 18 };
        const inside = rect.x > 2 && rect.y > 2 && rect.x + wide < orbit.width - 2 && rect.y + 18 < orbit.height - 2;
        if (!inside || taken.some((other) => overlap(other, rect))) continue;
        taken.push(rect);
        return `<span class="part-name" style="${at(orbit, x, y + dy)}">${esc(name)}</span>`;
      }
      return '';
    }).join('');
  }

  /** @param {Orbit} orbit @param {number} magnification */
  scale(orbit, magnification) {
    if (!this.places.some(({ deviation }) => Math.abs(deviation ?? 0) > 5e-5)) return '';
    return `<span class="scene-scale" style="${at(orbit, 10, orbit.height - 16)}">${esc(word('whisker_scale', { mag: num(magnification, 0) }))}</span>`;
  }
}

/** In shares of the box, so that paper of another width has it at the same place. @param {Orbit} orbit @param {number} x
 * @param {number} y */
const at = (orbit, x, y) => `left:${((100 * x) / orbit.width).toFixed(3)}%;top:${((100 * y) / orbit.height).toFixed(3)}%`;

/** The three axes in the corner. @param {Orbit} orbit */
function axesOf(orbit) {
  const [x0, y0] = [orbit.width - 52, orbit.height - 38];
  return ['X', 'Y', 'Z'].map((name, axis) => {
    const [dx, dy] = [orbit.right[axis] * 32, -orbit.up[axis] * 32];
    if (Math.hypot(dx, dy) < 4) return '';
    const angle = Math.atan2(dy, dx);
    const [x, y] = [x0 + dx, y0 + dy];
    const barb = (/** @type {number} */ turn) => `${(x - 5.5 * Math.cos(angle + turn)).toFixed(1)} ${(y - 5.5 * Math.sin(angle + turn)).toFixed(1)}`;
    return `<path d="M${x0} ${y0}L${x.toFixed(1)} ${y.toFixed(1)}M${barb(0.45)}L${x.toFixed(1)} ${y.toFixed(1)}L${barb(-0.45)}" fill="none" `
      + `stroke="var(--ink2)" stroke-width="1.3"/><text x="${(x0 + dx * 1.34).toFixed(1)}" y="${(y0 + dy * 1.34 + 4).toFixed(1)}" font-size="11.5" `
      + `fill="var(--ink2)" text-anchor="middle">${name}</text>`;
  }).join('');
}
