// Edges of a mesh as few long pieces: a round rim comes as thousands that are shorter than a pixel.

export const WELD = 1e4; // ends and corners within 0.1 um are one

/** Pieces that hang together, as one where they lie near a line.
 * @param {number[]} ends x y z x y z @param {number} within how far a piece may be from those that it stands for */
export function joined(ends, within) {
  /** @type {number[]} */
  const pieces = [];
  for (const chain of chainsOf(ends)) {
    const kept = keptOf(chain, within);
    for (let n = 1; n < kept.length; ++n) pieces.push(...chain[kept[n - 1]], ...chain[kept[n]]);
  }
  return pieces;
}

/** Ways along pieces from fork to fork, then rings. @param {number[]} ends */
function chainsOf(ends) {
  const points = Array.from({ length: ends.length / 3 }, (_, n) => ends.slice(3 * n, 3 * n + 3));
  const keys = points.map((point) => point.map((value) => Math.round(value * WELD)).join());
  /** @type {Map<string, number[]>} the ends that are at a place */
  const places = new Map();
  keys.forEach((key, n) => {
    const there = places.get(key);
    if (there) there.push(n);
    else places.set(key, [n]);
  });
  const endsAt = (/** @type {number} */ end) => places.get(keys[end]) ?? [];
  const used = new Uint8Array(points.length / 2);
  const walk = (/** @type {number} */ first) => {
    const chain = [points[first]];
    for (let from = /** @type {number | undefined} */ (first); from != null;) {
      used[from >> 1] = 1;
      const to = from ^ 1; // the other end of the piece
      chain.push(points[to]);
      const there = endsAt(to);
      from = there.length === 2 ? there.find((end) => !used[end >> 1]) : undefined;
    }
    return chain;
  };
  const chains = [];
  for (const mayStart of [(/** @type {number} */ end) => endsAt(end).length !== 2, () => true]) {
    for (let end = 0; end < points.length; ++end) {
      if (!used[end >> 1] && mayStart(end)) chains.push(walk(end));
    }
  }
  return chains;
}

/** Numbers of the points that say what a way is like (Douglas and Peucker). @param {number[][]} way @param {number} within */
function keptOf(way, within) {
  const kept = [0, way.length - 1];
  const open = [[0, way.length - 1]];
  for (let part = open.pop(); part; part = open.pop()) {
    const [first, last] = part;
    let [farthest, off] = [first, within];
    for (let n = first + 1; n < last; ++n) {
      const here = distance(way[n], way[first], way[last]);
      if (here > off) [farthest, off] = [n, here];
    }
    if (farthest === first) continue;
    kept.push(farthest);
    open.push([first, farthest], [farthest, last]);
  }
  return kept.sort((a, b) => a - b);
}

/** From a piece of a line; its ends may be one. @param {number[]} p @param {number[]} a @param {number[]} b */
function distance(p, a, b) {
  const [x, y, z] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [u, v, w] = [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
  const long = x * x + y * y + z * z;
  const share = long > 0 ? Math.max(0, Math.min(1, (u * x + v * y + w * z) / long)) : 0;
  return Math.hypot(u - share * x, v - share * y, w - share * z);
}
