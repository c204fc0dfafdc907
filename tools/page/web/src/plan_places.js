// Places in a plan view: origin of the frame, measured circles and centres, the place of a collision.
import { esc, num, um } from './markup.js';
import { flat } from './plan_planes.js';
import { word } from './words.js';

const OFF = 0.5; // mm; a wall further off its frame's origin than that is worth a dimension in a collision
const CROSS = 7; // px from the middle of a collision's cross to its ends
const LETTER = 7; // px that a bold letter needs, about
const NEAR = 1.2; // of its radius; a wall still further off is not the one that the frame is of

/** @typedef {import('./plan_view').PlanView} PlanView */
/** @typedef {import('./plan').Sheet} Sheet */

/** @param {number} x @param {number} y @param {number} arm px */
const cross = (x, y, arm) => `M${(x - arm).toFixed(1)} ${y.toFixed(1)}h${2 * arm}M${x.toFixed(1)} ${(y - arm).toFixed(1)}v${2 * arm}`;

/** Centre lines through the origin of the frame. @param {PlanView} view @param {Sheet} page */
export function drawOrigin(view, page) {
  const [x, y] = page.at(flat(view.from.origin, view.plane));
  const near = 0.06 * page.height;
  let d = '';
  if (x > 0 && x < page.width) d += `M${x.toFixed(1)} ${near.toFixed(1)}V${(page.height - near).toFixed(1)}`;
  if (y > 0 && y < page.height) d += `M${(0.04 * page.width).toFixed(1)} ${y.toFixed(1)}H${(0.96 * page.width).toFixed(1)}`;
  return d ? `<path d="${d}" stroke="var(--line2)" stroke-dasharray="12 3 2 3"/>` : '';
}

/** What was measured of round walls, magnified: circle, centre and how far that is from the true one.
 * @param {PlanView} view @param {Sheet} page */
export function measuredOf(view, page) {
  return view.measured.map(({ truth, circle }) => {
    const m = view.magnification ?? 1;
    const [du, dv] = [circle.u - truth.u, circle.v - truth.v];
    /** @type {import('./section').Flat[]} */
    const points = [];
    for (let n = 0; n < 180; ++n) {
      const angle = (n * Math.PI) / 90;
      const r = truth.r + m * (circle.r - truth.r + du * Math.cos(angle) + dv * Math.sin(angle));
      points.push([truth.u + r * Math.cos(angle), truth.v + r * Math.sin(angle)]);
    }
    const [x0, y0] = page.at([truth.u, truth.v]);
    const [x, y] = page.at([truth.u + m * du, truth.v + m * dv]);
    const isOff = Math.hypot(du, dv) >= 1e-4;
    const centre = isOff ? `<path d="M${x0.toFixed(1)} ${y0.toFixed(1)}L${x.toFixed(1)} ${y.toFixed(1)}${cross(x, y, 5)}" stroke="var(--accent)" `
      + 'stroke-width="2"/>' : `<path d="${cross(x0, y0, 5)}" stroke="var(--accent)" stroke-width="1.6"/>`;
    // A small circle has no room for it; the legend says it in any case.
    const text = isOff && truth.r * page.scale > 90 ? centreText(view.plane.name, [du, dv], [x, y]) : '';
    return `<path d="${page.path(points)}z" fill="none" stroke="var(--accent)" stroke-width="1.5" stroke-dasharray="5 3"/>${centre}${text}`;
  }).join('');
}

/** @param {string} axes names @param {number[]} off mm @param {number[]} at px */
function centreText(axes, off, [x, y]) {
  const below = off[1] > 0 ? -28 : 19;
  const lines = [0, 1].map((n) => `<text x="${(x + 8).toFixed(1)}" y="${(y + below + 14 * n).toFixed(1)}">${axes[n]} ${um(off[n])} µm</text>`);
  return `<g font-size="11.5" fill="var(--accent)" font-weight="600" class="halo">${lines.join('')}</g>`;
}

/** The place of a collision, the way that led there, and how far the nearest round wall is from where the frame has it.
 * @param {PlanView} view @param {Sheet} page */
export function drawCrash(view, page) {
  const contact = view.crash?.contact;
  if (!contact) return '';
  const place = flat(contact, view.plane);
  const [x, y] = page.at(place);
  let drawn = wallDistance(view, page, place);
  const last = view.run.ways.at(-1);
  const ball = view.run.ballAt(view.run.duration);
  if (last && ball) {
    const from = flat(last.points, view.plane);
    const to = flat(ball, view.plane);
    if (Math.hypot(to[0] - from[0], to[1] - from[1]) * page.scale > 4) drawn += page.arrow(from, to, 'var(--bad)', 2.2);
  }
  const { text, left } = crashWords(view, page, x);
  drawn += `<path d="M${x - CROSS} ${y - CROSS}l${2 * CROSS} ${2 * CROSS}m0 -${2 * CROSS}l-${2 * CROSS} ${2 * CROSS}" stroke="var(--bad)" stroke-width="3"/>`
    + `<text x="${(left ? x - 13 : x + 13).toFixed(1)}" y="${(y - 11).toFixed(1)}" class="halo" font-size="12" font-weight="600" fill="var(--bad)" `
    + `text-anchor="${left ? 'end' : 'start'}">${esc(text)}</text>`;
  return drawn;
}

/** What is said at the cross of a collision, on the side that has more room.
 * @param {PlanView} view @param {Sheet} page @param {number} x px of the cross */
function crashWords(view, page, x) {
  // What met what is said in English; the document has it on every page.
  const isEnglish = document.documentElement.lang === 'en';
  const text = isEnglish ? view.crash?.what ?? '' : word('collision');
  const left = x > page.width / 2;
  const room = left ? x : page.width - x;
  const most = Math.min(46, Math.floor((room - 16) / LETTER));
  return { text: text.length > most ? `${text.slice(0, most - 1)}…` : text, left };
}

/** What the cross of a collision and its words cover. @param {PlanView} view @param {Sheet} page
 * @returns {import('./plan_whiskers').Rect[]} */
export function crashBoxes(view, page) {
  const contact = view.crash?.contact;
  if (!contact) return [];
  const [x, y] = page.at(flat(contact, view.plane));
  const { text, left } = crashWords(view, page, x);
  const wide = text.length * LETTER;
  const reach = CROSS + 3;
  return [{ x: x - reach, y: y - reach, w: 2 * reach, h: 2 * reach },
    { x: left ? x - 13 - wide : x + 13, y: y - 22, w: wide, h: 15 }];
}

/** @param {PlanView} view @param {Sheet} page @param {import('./section').Flat} place */
function wallDistance(view, page, place) {
  const wall = view.nearestRound(place);
  const origin = flat(view.from.origin, view.plane);
  if (!wall) return '';
  const distance = Math.hypot(wall.u - origin[0], wall.v - origin[1]);
  const [ox, oy] = page.at(origin);
  const isSeen = ox > 0 && oy > 0 && ox < page.width && oy < page.height;
  if (distance < OFF || distance > NEAR * wall.r || !isSeen) return '';
  const [cx, cy] = page.at([wall.u, wall.v]);
  const r = (wall.r * page.scale).toFixed(1);
  const text = word('wall_off', { distance: num(distance), frame: view.from.name });
  const middle = Math.min(Math.max((cx + ox) / 2, 6 + text.length * 3), page.width - 6 - text.length * 3);
  const level = Math.min(Math.max(cy, oy) + 40, page.height - 44);
  return `<circle cx="${ox.toFixed(1)}" cy="${oy.toFixed(1)}" r="${r}" fill="none" stroke="var(--ink)" stroke-dasharray="6 4"/>`
    + `<path d="${cross(cx, cy, 6)}" stroke="var(--ink)" stroke-width="1.4"/>`
    + `${page.arrow(origin, [wall.u, wall.v], 'var(--bad)', 1.4)}<text x="${middle.toFixed(1)}" y="${level.toFixed(1)}" class="halo" `
    + `font-size="12" font-weight="600" fill="var(--bad)" text-anchor="middle">${esc(text)}</text>`;
}
