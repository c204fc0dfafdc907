// The legend under a plan view.
import { esc, um } from './markup.js';
import { word } from './words.js';

/** @param {string} ink @param {number} [width] @param {string} [dashes] */
const swatch = (ink, width = 5, dashes = '') => `<svg width="18" height="8" aria-hidden="true"><path d="M0 4H18" stroke="${ink}" `
  + `stroke-width="${width}"${dashes ? ` stroke-dasharray="${dashes}"` : ''}/></svg>`;

/** @param {string} drawn @param {string} text */
const key = (drawn, text) => `<span class="key">${drawn}${esc(text)}</span>`;

/** @param {import('./plan_view').PlanView} view @param {boolean} compared @param {boolean} hasZones of tolerances */
export function planKeys(view, compared, hasZones) {
  const keys = [];
  if (view.crash) {
    keys.push(key(swatch('var(--ink)', 1.6), word('where_wall_is')), key(swatch('var(--bad)', 2.2), word('broke_off')));
  }
  const { contacts } = view;
  if (contacts.some(({ partDeviation }) => partDeviation != null)) keys.push(key(swatch('var(--ink)'), word('own_deviation')));
  if (view.magnification) keys.push(key(swatch('var(--accent)'), word('measured_adds')));
  const axes = view.plane.name;
  for (const { truth, circle } of view.measured) {
    const values = { u: axes[0], v: axes[1], du: um(circle.u - truth.u), dv: um(circle.v - truth.v), dd: um(2 * (circle.r - truth.r)) };
    keys.push(key(swatch('var(--accent)', 1.5, '5 3'), word('measured_circle', values)));
  }
  if (hasZones) {
    const box = '<svg width="18" height="10" aria-hidden="true"><rect width="18" height="10" fill="var(--good2)" stroke="var(--good)" stroke-width=".8"/></svg>';
    keys.push(key(box, word('tolerance_of_size')));
  }
  if (contacts.length && !view.crash) keys.push(key(swatch('var(--skip)', 1.3), word('probing_direction')));
  if (contacts.some((contact) => !contact.counts)) keys.push(key('', word('thin_does_not_count')));
  if (compared) keys.push(key(swatch('var(--accent)', 1.3, '4 3'), word('other_run')));
  return keys.join('');
}
