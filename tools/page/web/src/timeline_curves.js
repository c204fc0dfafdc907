// One curve of the time line on its scale; what lies beyond that is not drawn as if it lay at the edge.
import { decimalsWithin, num } from './markup.js';

const HEIGHT = 34; // px of the scale
const FOOT = 38; // px; where its lower end lies
const [BELOW, ABOVE] = [-0.05, 1.06]; // of the scale; so far a curve is drawn
const ROOM = 44; // px that a value needs
const TOLD = 0.02; // of the scale: so well a value is told

/** @typedef {[number, number]} Place px and mm */
/** Where a curve is beyond its scale: px, and the value farthest from it. @typedef {{from: number, until: number, isOver: boolean, most: number}} Beyond */

/** @param {number} value @param {[number, number]} scale */
const share = (value, [low, high]) => (value - low) / (high - low);

/** px of a value. @param {number} value @param {[number, number]} scale mm @param {number} top px */
export const levelOf = (value, scale, top) => top + FOOT - share(value, scale) * HEIGHT;

/** @param {number} value @param {[number, number]} scale */
const side = (value, scale) => (share(value, scale) < BELOW ? -1 : share(value, scale) > ABOVE ? 1 : 0);

/** Pieces of a curve within its scale, and where between them it is beyond.
 * @param {Place[]} curve @param {[number, number]} scale mm, its lower and upper end
 * @returns {{within: Place[][], beyond: Beyond[]}} */
export function onScale(curve, scale) {
  const edges = [BELOW, ABOVE].map((at) => scale[0] + at * (scale[1] - scale[0]));
  /** @type {Place[][]} */
  const within = [];
  /** @type {Beyond[]} */
  const beyond = [];
  curve.forEach(([px, value], n) => {
    const before = curve[n - 1] ?? [px, value];
    const [was, is] = [side(before[1], scale), side(value, scale)];
    const crossing = (/** @type {number} */ over) => {
      const edge = edges[over > 0 ? 1 : 0];
      return before[0] + ((edge - before[1]) / (value - before[1])) * (px - before[0]);
    };
    if (was && was !== is) {
      beyond[beyond.length - 1].until = crossing(was);
      within.push([[crossing(was), edges[was > 0 ? 1 : 0]]]);
    }
    if (!is) {
      if (!within.length) within.push([]);
      within[within.length - 1].push([px, value]);
    } else if (n && was === is) {
      const last = beyond[beyond.length - 1];
      last.until = px;
      if (Math.abs(value - edges[0]) > Math.abs(last.most - edges[0])) last.most = value;
    } else {
      const from = n ? crossing(is) : px;
      if (n && within.length) within[within.length - 1].push([from, edges[is > 0 ? 1 : 0]]);
      beyond.push({ from, until: px, isOver: is > 0, most: value });
    }
  });
  return { within, beyond };
}

/** The lines of a curve as a path, and a row of dots with an arrow outwards, and how far it goes, where it is beyond its scale.
 * @param {Place[]} curve @param {[number, number]} scale @param {number} top px @returns {{line: string, dots: string, arrows: string, values: string}} */
export function drawnCurve(curve, scale, top) {
  const { within, beyond } = onScale(curve, scale);
  const line = within.map((piece) => piece.map(([px, value], n) => `${n ? 'L' : 'M'}${px.toFixed(1)} ${levelOf(value, scale, top).toFixed(1)}`).join('')).join('');
  let [dots, arrows, values] = ['', '', ''];
  for (const { from, until, isOver, most } of beyond) {
    const edge = top + FOOT - (isOver ? ABOVE : BELOW) * HEIGHT;
    const middle = (from + until) / 2;
    const out = isOver ? -1 : 1;
    dots += `M${from.toFixed(1)} ${edge.toFixed(1)}H${until.toFixed(1)}`;
    arrows += `M${(middle - 3.5).toFixed(1)} ${(edge - 4 * out).toFixed(1)}h7l-3.5 ${5 * out}z`;
    if (until - from < ROOM) continue;
    values += `<text x="${(middle + 7).toFixed(1)}" y="${(edge + (isOver ? 9 : -3)).toFixed(1)}" class="halo">${num(most, decimalsWithin(most, TOLD * (scale[1] - scale[0])))}</text>`;
  }
  return { line, dots, arrows, values };
}
