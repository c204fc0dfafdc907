// Sections of meshes by planes, and circles through points.

const JOIN = 1e4; // ends of two segments are one where they agree to 0.1 um
const ROUND = 0.01; // of the radius; an outline that strays less from its circle is round

/** @typedef {[number, number]} Flat */

/**
 * Where a plane cuts a mesh: pairs of points as x y z x y z, in machine coordinates.  A corner on the plane counts
 * as above it, so that each triangle gives none or one pair.
 * @param {import('./types').Part} part
 * @param {number[]} normal unit
 * @param {number} offset of the plane from the machine's origin along the normal
 */
export function cutsOf(part, normal, offset) {
  const { positions, triangles, origin } = part;
  const own = offset - (normal[0] * origin[0] + normal[1] * origin[1] + normal[2] * origin[2]);
  const count = positions.length / 3;
  const heights = new Float64Array(count);
  for (let n = 0; n < count; ++n) {
    heights[n] = normal[0] * positions[3 * n] + normal[1] * positions[3 * n + 1] + normal[2] * positions[3 * n + 2] - own;
  }
  /** @type {number[]} */
  const cuts = [];
  for (let n = 0; n < triangles.length; n += 3) {
    const above = (heights[triangles[n]] >= 0 ? 1 : 0) + (heights[triangles[n + 1]] >= 0 ? 1 : 0)
      + (heights[triangles[n + 2]] >= 0 ? 1 : 0);
    if (above === 0 || above === 3) continue;
    for (let side = 0; side < 3; ++side) {
      const a = triangles[n + side];
      const b = triangles[n + ((side + 1) % 3)];
      if (heights[a] >= 0 === heights[b] >= 0) continue;
      // From the lower corner, whichever way the triangle goes round: both neighbours get the same point.
      const [low, high] = a < b ? [a, b] : [b, a];
      const share = heights[low] / (heights[low] - heights[high]);
      for (let axis = 0; axis < 3; ++axis) {
        const from = positions[3 * low + axis];
        cuts.push(origin[axis] + from + share * (positions[3 * high + axis] - from));
      }
    }
  }
  return cuts;
}

/**
 * Segments joined to outlines; one that does not close ends where it ends.
 * @param {Flat[]} ends two a segment
 * @returns {Flat[][]}
 */
export function outlinesOf(ends) {
  /** @type {Map<string, number[]>} */
  const at = new Map();
  const keys = ends.map(([u, v]) => `${Math.round(u * JOIN)} ${Math.round(v * JOIN)}`);
  keys.forEach((key, n) => {
    const here = at.get(key);
    if (here) here.push(n);
    else at.set(key, [n]);
  });
  const used = new Uint8Array(ends.length / 2);
  const outlines = [];
  for (let first = 0; first < ends.length; first += 2) {
    if (used[first >> 1]) continue;
    used[first >> 1] = 1;
    const outline = [ends[first], ends[first + 1]];
    let end = first + 1;
    for (;;) {
      const next = at.get(keys[end])?.find((n) => !used[n >> 1]);
      if (next == null) break;
      used[next >> 1] = 1;
      end = next ^ 1;
      outline.push(ends[end]);
    }
    outlines.push(outline);
  }
  return outlines;
}

/**
 * The circle with the least squares of (distance squared - radius squared): exact for points of a circle.
 * Kasa 1976, A circle fitting procedure and its error analysis.
 * @param {Flat[]} points three or more
 * @returns {{u: number, v: number, r: number} | null} null where they lie on a line
 */
export function circleOf(points) {
  const n = points.length;
  const mu = points.reduce((sum, p) => sum + p[0], 0) / n;
  const mv = points.reduce((sum, p) => sum + p[1], 0) / n;
  let [suu, svv, suv, suz, svz] = [0, 0, 0, 0, 0];
  for (const [pu, pv] of points) {
    const [u, v] = [pu - mu, pv - mv];
    const z = u * u + v * v;
    suu += u * u;
    svv += v * v;
    suv += u * v;
    suz += u * z;
    svz += v * z;
  }
  const det = suu * svv - suv * suv;
  if (!(det > 1e-9 * (suu + svv) ** 2)) return null;
  const u = (suz * svv - svz * suv) / (2 * det);
  const v = (svz * suu - suz * suv) / (2 * det);
  return { u: mu + u, v: mv + v, r: Math.sqrt(u * u + v * v + (suu + svv) / n) };
}

/**
 * The circle that an outline is, where it is one.
 * @param {Flat[]} outline
 */
export function roundOf(outline) {
  if (outline.length < 9) return null;
  const circle = circleOf(outline);
  if (!circle) return null;
  const strays = outline.some(([u, v]) => Math.abs(Math.hypot(u - circle.u, v - circle.v) - circle.r) > ROUND * circle.r);
  // A short arc is no round wall: its ends are far from each other's opposite.
  const span = Math.max(...outline.map(([u]) => u)) - Math.min(...outline.map(([u]) => u));
  return strays || span < 1.8 * circle.r ? null : circle;
}
