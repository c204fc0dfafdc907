// The planes that a plan view looks onto: along the axes of the machine, or of a part that lies askew to them.
import { turned } from './turn.js';
import { dot } from './vectors.js';
import { word } from './words.js';

/** Right, up and what looks out of it, as unit vectors of the machine; `axis` is the letter of the last.
 * @typedef {{name: string, axis: string, right: number[], up: number[], out: number[]}} Plane */
/** @typedef {import('./section').Flat} Flat */
/** @typedef {import('./types').Part} Part */

const AXES = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
const ALONG = 1 - 1e-9; // cosine; of directions that are the same but for rounding

/** @param {number[]} point @param {Plane} plane @returns {Flat} */
export const flat = (point, plane) => [dot(point, plane.right), dot(point, plane.up)];

/** How far out of the plane a point or a direction is. @param {number[]} point @param {Plane} plane */
export const height = (point, plane) => dot(point, plane.out);

/** Whether no axis of the machine is the part's own Z: its sections across that would be skew. @param {Part} part */
const isTilted = ({ turn }) => Math.max(...turned([0, 0, 1], turn).map(Math.abs)) < ALONG;

/** The planes of a part. @param {Part} part @returns {Plane[]} */
export function planesOf(part) {
  const [x, y, z] = isTilted(part) ? AXES.map((axis) => turned(axis, part.turn)) : AXES;
  return [
    { name: 'XY', axis: 'Z', right: x, up: y, out: z },
    { name: 'XZ', axis: 'Y', right: x, up: z, out: y },
    { name: 'YZ', axis: 'X', right: y, up: z, out: x },
  ];
}

/** What the numbers of a plan are counted from. @param {Part} part @param {import('./run').Run} run */
export const frameOf = (part, run) => (isTilted(part) ? { name: word('part_frame'), origin: part.origin } : run.frame);

/** The plane that the touches' moves lie in. @param {import('./types').Contact[]} contacts @param {Plane[]} planes */
export function planeOf(contacts, planes) {
  const out = planes.map((plane) => contacts.reduce((sum, { normal }) => sum + Math.abs(normal ? height(normal, plane) : 0), 0));
  return planes[out.indexOf(Math.min(...out))];
}

/** The least box about a part that stands along the plane: its near and its far corner as right, up and out.
 * @param {Part} part @param {Plane} plane */
export function boundsOf({ positions, origin }, { right, up, out }) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const axes = [right, up, out];
  for (let at = 0; at < positions.length; at += 3) {
    const point = [origin[0] + positions[at], origin[1] + positions[at + 1], origin[2] + positions[at + 2]];
    for (let n = 0; n < 3; ++n) {
      const value = dot(point, axes[n]);
      if (value < low[n]) low[n] = value;
      if (value > high[n]) high[n] = value;
    }
  }
  return { low, high };
}
