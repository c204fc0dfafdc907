// The tolerance of a size about what was measured of it: rings at round walls, bands at flat ones.
import { flat } from './plan_planes.js';

const BAND = 34; // px along a flat wall

/** @typedef {import('./plan_view').PlanView} PlanView */
/** @typedef {import('./plan').Sheet} Sheet */

const LOOK = 'fill="var(--good2)" fill-opacity=".85" fill-rule="evenodd" stroke="var(--good)" stroke-width=".8"';

/** Contacts whose size has a tolerance. @param {PlanView} view */
const limited = (view) => view.contacts.filter(({ limits }) => limits != null);

/** @param {PlanView} view */
export const hasZones = (view) => view.magnification != null && limited(view).length > 0;

/** @param {PlanView} view @param {Sheet} page */
export function zonesOf(view, page) {
  if (!hasZones(view)) return '';
  const drawn = new Set();
  for (const contact of limited(view)) {
    const wall = view.wallAt(flat(contact.place ?? [], view.plane));
    drawn.add(wall?.circle ? ring(contact, wall.circle, view, page) : band(contact, view, page));
  }
  return [...drawn].join('');
}

/** About the measured centre. @param {import('./types').Contact} contact @param {{u: number, v: number, r: number}} truth
 * @param {PlanView} view @param {Sheet} page */
function ring(contact, truth, view, page) {
  const m = view.magnification ?? 1;
  const measured = view.measured.find((each) => each.truth === truth)?.circle ?? truth;
  const [cu, cv] = [truth.u + m * (measured.u - truth.u), truth.v + m * (measured.v - truth.v)];
  const [u, v] = flat(contact.place ?? [], view.plane);
  const [nu, nv] = flat(contact.normal ?? [], view.plane);
  const outwards = nu * (u - truth.u) + nv * (v - truth.v) > 0 ? -1 : 1; // deeper in a bore is further out
  const [x, y] = page.at([cu, cv]);
  const circles = (contact.limits ?? []).map((depth) => {
    const r = Math.max(0, (truth.r + outwards * m * depth) * page.scale).toFixed(1);
    return `M${(x - Number(r)).toFixed(1)} ${y.toFixed(1)}a${r} ${r} 0 1 0 ${2 * Number(r)} 0a${r} ${r} 0 1 0 ${-2 * Number(r)} 0z`;
  });
  return `<path class="zone" d="${circles.join('')}" ${LOOK}/>`;
}

/** Along the wall at the touch. @param {import('./types').Contact} contact @param {PlanView} view @param {Sheet} page */
function band(contact, view, page) {
  const m = view.magnification ?? 1;
  const [nu, nv] = flat(contact.normal ?? [], view.plane);
  const length = Math.hypot(nu, nv) || 1;
  const [du, dv] = [-nu / length, -nv / length];
  const [x, y] = page.at(flat(contact.place ?? [], view.plane));
  const corner = (/** @type {number} */ depth, /** @type {number} */ along) => {
    const deep = depth * m * page.scale;
    return `${(x + du * deep + dv * along).toFixed(1)} ${(y - dv * deep + du * along).toFixed(1)}`;
  };
  const [low, high] = contact.limits ?? [0, 0];
  return `<path class="zone" d="M${corner(low, -BAND)}L${corner(low, BAND)}L${corner(high, BAND)}L${corner(high, -BAND)}z" ${LOOK}/>`;
}
