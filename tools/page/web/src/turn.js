// Turns of what carries the ball, as quaternions x y z w.

/** @typedef {number[]} Turn */

/** @type {Turn} */
export const UPRIGHT = [0, 0, 0, 1];

/** A point turned about the origin. @param {number[]} point @param {Turn} turn */
export function turned([px, py, pz], [x, y, z, w]) {
  const [tx, ty, tz] = [2 * (y * pz - z * py), 2 * (z * px - x * pz), 2 * (x * py - y * px)];
  return [px + w * tx + y * tz - z * ty, py + w * ty + z * tx - x * tz, pz + w * tz + x * ty - y * tx];
}

/** The same turned back. @param {number[]} point @param {Turn} turn */
export const turnedBack = (point, [x, y, z, w]) => turned(point, [-x, -y, -z, w]);

/** The shortest way from one turn to another, a share of it. @param {Turn} from @param {Turn} to @param {number} share */
export function between(from, to, share) {
  const sign = from.reduce((sum, value, n) => sum + value * to[n], 0) < 0 ? -1 : 1;
  const mixed = from.map((value, n) => value + share * (sign * to[n] - value));
  const long = Math.hypot(...mixed);
  return mixed.map((value) => value / long);
}

/** That brings +Z to a direction. @param {number[]} along unit @returns {Turn} */
export function fromZ([x, y, z]) {
  if (z < -1 + 1e-12) return [1, 0, 0, 0];
  const long = Math.sqrt(2 * (1 + z));
  return [-y / long, x / long, 0, long / 2];
}
