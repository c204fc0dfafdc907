// Touches of a plan view: the ball in true size, the deviation magnified along the normal, the number, the value.
import { mark, um } from './markup.js';
import { crashBoxes } from './plan_places.js';
import { flat } from './plan_planes.js';

const LABELS = 80; // numbers; more would be no plan view
const BESIDE = 3.6; // px between the whiskers of one place

/** @typedef {import('./types').Contact} Contact */
/** @typedef {{x: number, y: number, w: number, h: number}} Rect */
/** @typedef {{contact: Contact, at: import('./section').Flat, into: import('./section').Flat, beside: number}} Whisker */

/** Where other labels stand, and balls, on which no value is readable.
 * @typedef {{taken: Rect[], covered: Rect[]}} Room */

/** @param {Rect} a @param {Rect} b */
const overlap = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;

/**
 * @param {import('./plan_view').PlanView} view
 * @param {import('./plan').Sheet} page
 * @param {number | null} chosen number of the chosen touch
 */
export function whiskersOf(view, page, chosen) {
  const whiskers = placed(view);
  const order = [...whiskers].sort((a, b) => rank(a.contact, chosen) - rank(b.contact, chosen));
  /** @type {Rect[]} */
  const taken = [{ x: page.width - 110, y: page.height - 84, w: 110, h: 84 }, ...crashBoxes(view, page)];
  const balls = ballsOf(view, page);
  const covered = balls.map(({ x, y, radius }) => ({ x: x - radius, y: y - radius, w: 2 * radius, h: 2 * radius }));
  const labels = order.slice(0, LABELS).map((whisker) => label(whisker, view, page, chosen, { taken, covered }));
  return circles(balls) + bars(whiskers, view, page) + labels.reverse().join('');
}

/** @param {Contact} contact @param {number | null} chosen */
const rank = (contact, chosen) => (contact.number === chosen ? 0 : contact.counts ? 1 : 2);

/** Touches of one place stand beside each other. @param {import('./plan_view').PlanView} view @returns {Whisker[]} */
function placed(view) {
  /** @type {Map<string, Whisker[]>} */
  const groups = new Map();
  for (const contact of view.contacts) {
    const at = flat(contact.place ?? [], view.plane);
    const normal = flat(contact.normal ?? [], view.plane);
    const length = Math.hypot(...normal) || 1;
    const key = `${at.map((v) => Math.round(v * 2)).join()} ${normal.map((v) => v.toFixed(1)).join()}`;
    const group = groups.get(key) ?? [];
    group.push({ contact, at, into: [-normal[0] / length, -normal[1] / length], beside: 0 });
    groups.set(key, group);
  }
  for (const group of groups.values()) {
    const gap = Math.min(BESIDE, 22 / group.length);
    group.forEach((whisker, n) => { whisker.beside = (n - (group.length - 1) / 2) * gap; });
  }
  return [...groups.values()].flat();
}

/** Where balls stand, px; those of about one place are one. @param {import('./plan_view').PlanView} view
 * @param {import('./plan').Sheet} page */
function ballsOf(view, page) {
  /** @type {Map<string, {x: number, y: number, radius: number}>} */
  const balls = new Map();
  for (const { ball, radius: own } of view.contacts) {
    if (!ball) continue;
    const radius = own * page.scale;
    const [x, y] = page.at(flat(ball, view.plane));
    const key = `${Math.round(x / 3)} ${Math.round(y / 3)} ${Math.round(radius)}`;
    if (!balls.has(key)) balls.set(key, { x, y, radius });
  }
  return [...balls.values()];
}

/** @param {ReturnType<typeof ballsOf>} balls */
const circles = (balls) => balls.map(({ x, y, radius }) => `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${radius.toFixed(1)}" `
  + 'fill="var(--paper)" fill-opacity=".55" stroke="var(--ink3)"/>'
  + `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="1.6" fill="var(--ink3)"/>`).join('');

/** px of a place so deep in the wall, magnified. @param {Whisker} whisker @param {number} depth mm
 * @param {import('./plan_view').PlanView} view @param {import('./plan').Sheet} page */
function tip(whisker, depth, view, page) {
  const [du, dv] = whisker.into;
  const [x, y] = page.at(whisker.at);
  const long = depth * (view.magnification ?? 1) * page.scale;
  return [x + du * long + dv * whisker.beside, y - dv * long + du * whisker.beside];
}

/** To half a pixel. @param {number} px */
const rounded = (px) => (Math.round(px * 2) / 2).toString();

/** @param {Whisker[]} whiskers @param {import('./plan_view').PlanView} view @param {import('./plan').Sheet} page */
function bars(whiskers, view, page) {
  const path = (/** @type {number[]} */ a, /** @type {number[]} */ b) => `M${a.map((v) => rounded(v)).join(' ')}L${b.map((v) => rounded(v)).join(' ')}`;
  // Whiskers that fall on the same pixels are one: ten thousand touches of a wall cost what a few do.
  const sets = () => /** @type {Set<string>} */ (new Set());
  const drawn = { own: [sets(), sets()], adds: [sets(), sets()], foot: sets() };
  for (const whisker of whiskers) {
    const { deviation, partDeviation, counts } = whisker.contact;
    if (deviation == null) continue;
    const thin = counts ? 0 : 1;
    const own = partDeviation ?? 0;
    const [foot, middle, end] = [0, own, own + deviation].map((depth) => tip(whisker, depth, view, page));
    if (own) drawn.own[thin].add(path(foot, middle));
    drawn.adds[thin].add(path(middle, end));
    const [du, dv] = whisker.into;
    const half = counts ? 4 : 2;
    drawn.foot.add(path([foot[0] - dv * half, foot[1] - du * half], [foot[0] + dv * half, foot[1] + du * half]));
  }
  const line = (/** @type {Set<string>} */ d, /** @type {string} */ look) => `<path class="whisker" d="${[...d].join('')}" ${look}/>`;
  const lines = (/** @type {Set<string>[]} */ d, /** @type {string} */ ink) => line(d[0], `stroke="${ink}" stroke-width="5"`)
    + line(d[1], `stroke="${ink}" stroke-width="2.5" opacity=".8"`);
  return lines(drawn.own, 'var(--ink)') + lines(drawn.adds, 'var(--accent)') + line(drawn.foot, 'stroke="var(--ink)" stroke-width="2"');
}

/** Number and value behind the end of a whisker; the value only where it has room, the number moved out until it has.
 * @param {Whisker} whisker @param {import('./plan_view').PlanView} view @param {import('./plan').Sheet} page
 * @param {number | null} chosen @param {Room} room */
function label(whisker, view, page, chosen, room) {
  const { taken } = room;
  const { contact } = whisker;
  const isChosen = contact.number === chosen;
  const [du, dv] = whisker.into;
  const far = Math.max(0, contact.deviation ?? 0, (contact.deviation ?? 0) + (contact.partDeviation ?? 0));
  // Within a small boss is no room: there the number stands behind the ball.
  const [fu, fv] = [whisker.at[0] - view.frame.u, whisker.at[1] - view.frame.v];
  const isBoss = du * fu + dv * fv < 0;
  const ball = 2 * contact.radius * page.scale;
  const foot = isBoss ? tip(whisker, 0, view, page) : tip(whisker, far, view, page);
  for (let out = 14; out < 80; out += 9) {
    const along = isBoss ? -(ball + out) : out;
    const x = foot[0] + du * along;
    const y = foot[1] - dv * along;
    if (x < 10 || x > page.width - 10 || y < 10 || y > page.height - 24) return '';
    const box = { x: x - 11, y: y - 9.5, w: 22, h: 19 };
    if (taken.some((other) => overlap(other, box))) continue;
    taken.push(box);
    return mark(contact, x, y, isChosen) + (view.magnification ? value(contact, x, y, isBoss ? -du : du, page, room, isChosen) : '');
  }
  return '';
}

/** @param {Contact} contact @param {number} x @param {number} y @param {number} du @param {import('./plan').Sheet} page
 * @param {Room} room @param {boolean} isChosen */
function value(contact, x, y, du, page, { taken, covered }, isChosen) {
  if (contact.deviation == null) return '';
  const text = um(contact.deviation + (contact.partDeviation ?? 0)) + (page.width < 460 ? '' : ' µm');
  const wide = text.length * 7.3;
  for (const side of du < -0.3 ? [-1, 1] : [1, -1]) {
    const from = x + side * 13;
    const box = { x: side > 0 ? from : from - wide, y: y - 8, w: wide, h: 16 };
    if (box.x < 2 || box.x + box.w > page.width - 2 || [...taken, ...covered].some((other) => overlap(other, box))) continue;
    taken.push(box);
    const bold = contact.counts || isChosen;
    return `<text x="${from.toFixed(1)}" y="${(y + 4).toFixed(1)}" font-size="12" class="halo"${bold ? ' font-weight="600"' : ''} `
      + `fill="${bold ? 'var(--ink)' : 'var(--ink3)'}" text-anchor="${side > 0 ? 'start' : 'end'}">${text}</text>`;
  }
  return '';
}
