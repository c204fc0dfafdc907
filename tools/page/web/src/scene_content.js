// What stands in the scene, without a word on how it is drawn: solids, ways, contacts, where parts are cut open.
import { cutsOf } from './section.js';
import { SolidEdges, cylinder } from './solid_edges.js';
import { fromZ, turned } from './turn.js';

const STRAIGHT = 1e-3; // mm; points of a way nearer than that to a line say nothing
const SAME = 10; // contacts within 1/SAME mm are one place
const CONTACTS = 5000;
const INWARD = 0.8; // of the touches of a part that is cut open
const HALF_OPEN = (40 * Math.PI) / 180; // the wedge that is cut out spans 180 degrees less twice this

/** @typedef {import('./types').Part} Part */
/** @typedef {import('./types').Contact} Contact */
/** @typedef {{part: Part, edges: SolidEdges, apex: number[] | null}} Solid */
/** @typedef {{positions: Float32Array, triangles: Uint32Array, edges: SolidEdges}} Stylus */

/** @param {Part[]} parts @param {import('./run').Run} run @returns {Solid[]} */
export function solidsOf(parts, run) {
  return parts.map((part) => ({ part, edges: new SolidEdges(part), apex: apexOf(part, run) }));
}

/** Where a part is cut open: at the middle of the touches that are in it, not of those around it.
 * @param {Part} part @param {import('./run').Run} run */
export function apexOf(part, run) {
  const points = run.hits.filter(({ touch }) => touch.part === part.name);
  const { collision } = run;
  if (!points.length) {
    const isHit = collision?.part === part.name && collision.contact;
    return isHit ? [0, 1, 2].map((axis) => (part.box.low[axis] + part.box.high[axis]) / 2) : null;
  }
  const middle = middleOf(points.map(({ place }) => place ?? []));
  const inward = points.filter(({ place, normal }) => place && normal
    && (place[0] - middle[0]) * normal[0] + (place[1] - middle[1]) * normal[1] < 0);
  // A part with bosses and bores stays whole: its pins must not vanish with what is cut away.
  if (inward.length < 2 || inward.length < INWARD * points.length) return null;
  return middleOf(inward.map(({ place }) => place ?? []));
}

/** @param {number[][]} points */
function middleOf(points) {
  return [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  });
}

/** The two planes of the wedge that is open towards the viewer: normals that look into it. @param {number} azimuth degrees */
export function wedgeOf(azimuth) {
  const a = (azimuth * Math.PI) / 180;
  return [a + HALF_OPEN, a - HALF_OPEN].map((angle) => [Math.cos(angle), Math.sin(angle), 0]);
}

/** Outlines of the cut faces of a solid. @param {Solid} solid @param {number[][]} wedge */
export function cutOutlines({ part, apex }, wedge) {
  if (!apex) return [];
  const kept = [];
  for (const [normal, other] of [wedge, [...wedge].reverse()]) {
    const at = (/** @type {number[]} */ n) => n[0] * apex[0] + n[1] * apex[1];
    const cuts = cutsOf(part, normal, at(normal));
    for (let n = 0; n < cuts.length; n += 6) {
      const x = (cuts[n] + cuts[n + 3]) / 2;
      const y = (cuts[n + 1] + cuts[n + 4]) / 2;
      if (other[0] * x + other[1] * y > at(other)) kept.push(...cuts.slice(n, n + 6));
    }
  }
  return kept;
}

/** Ends of the straight pieces of all ways of a kind, each once, as x y z x y z.
 * @param {import('./run').Run} run @param {import('./types').Kind | null} kind null for all */
export function piecesOf(run, kind) {
  /** @type {number[]} */
  const pieces = [];
  const seen = new Set();
  const push = (/** @type {number[]} */ a, /** @type {number[]} */ b) => {
    const key = [...a, ...b].map((value) => Math.round(value * 50)).join();
    if (seen.has(key)) return;
    seen.add(key);
    pieces.push(a[0], a[1], a[2], b[0], b[1], b[2]);
  };
  for (const { kind: own, points } of run.ways) {
    if (kind && own !== kind) continue;
    let from = points.slice(0, 3);
    let last = from;
    for (let n = 3; n < points.length; n += 3) {
      const next = points.slice(n, n + 3);
      if (last !== from && bends(from, last, next)) {
        push(from, last);
        from = last;
      }
      last = next;
    }
    if (last !== from) push(from, last);
  }
  return pieces;
}

/** @param {number[]} a @param {number[]} b @param {number[]} c whether b lies off the line from a to c */
function bends(a, b, c) {
  const ab = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const ac = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const long = ac[0] ** 2 + ac[1] ** 2 + ac[2] ** 2;
  const share = long > 0 ? (ab[0] * ac[0] + ab[1] * ac[1] + ab[2] * ac[2]) / long : 0;
  const off = Math.hypot(ab[0] - share * ac[0], ab[1] - share * ac[1], ab[2] - share * ac[2]);
  return off > STRAIGHT || share < 0 || share > 1;
}

/** Touches with a signal, one a place: the last there, for it is the one that counts. @param {import('./run').Run} run */
export function placesOf(run) {
  /** @type {Map<string, Contact>} */
  const places = new Map();
  for (const contact of run.hits) {
    const key = (contact.place ?? []).map((value) => Math.round(value * SAME)).join();
    const there = places.get(key);
    if (!there || contact.counts || !there.counts) places.set(key, contact);
    if (places.size >= CONTACTS) break;
  }
  return [...places.values()];
}

/** Stem, body and holder of the probe above its ball, whose centre is the origin, and the arms of further balls.
 * @param {import('./run').Run} run @returns {Stylus[]} */
export function stylusOf(run) {
  const { probe } = run.figures;
  if (!probe) return [];
  let from = 0;
  const upright = [probe.stem, probe.body, probe.holder].filter((piece) => piece != null).map(({ diameter, length }) => {
    from += length;
    return cylinder(diameter, from - length, from);
  });
  const arms = (probe.arms ?? []).map(({ from: root, to, diameter }) => {
    const along = to.map((value, axis) => value - root[axis]);
    const long = Math.hypot(...along);
    const turn = fromZ(along.map((value) => value / long));
    const mesh = cylinder(diameter, 0, long);
    for (let n = 0; n < mesh.positions.length; n += 3) {
      const placed = turned([...mesh.positions.subarray(n, n + 3)], turn);
      mesh.positions.set(placed.map((value, axis) => value + root[axis]), n);
    }
    return mesh;
  });
  return [...upright, ...arms].map((mesh) => ({ ...mesh, edges: new SolidEdges(mesh) }));
}

/** What the scene fits: parts that are touched, and where the probe works. @param {Part[]} parts
 * @param {import('./run').Run} run @returns {import('./types').Box} */
export function boxOf(parts, run) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const put = (/** @type {number[]} */ point) => point.forEach((value, axis) => {
    low[axis] = Math.min(low[axis], value);
    high[axis] = Math.max(high[axis], value);
  });
  const touched = new Set([...run.hits.map(({ touch }) => touch.part), run.collision?.part]);
  const named = parts.filter((part) => touched.has(part.name));
  const shown = named.length ? named : parts.filter((part) => !part.fixture);
  for (const part of shown) [part.box.low, part.box.high].forEach(put);
  for (const { kind, points } of run.ways) {
    if (kind === 'rapid' && shown.length) continue;
    for (let n = 0; n < points.length; n += 3) put([points[n], points[n + 1], points[n + 2]]);
  }
  if (!(high[0] >= low[0])) return { low: [-50, -50, -50], high: [50, 50, 50] };
  const wide = Math.max(high[0] - low[0], high[1] - low[1]);
  high[2] += 0.35 * wide; // the stylus above the part
  return { low, high };
}
