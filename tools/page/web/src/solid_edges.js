// Edges of a mesh: sharp ones, and those where it turns away from the viewer.
import { joined, WELD } from './edge_chains.js';

const SHARP = Math.cos((20 * Math.PI) / 180); // faces that meet at a greater angle have an edge between them
const ROUND = 1e-4; // of the size of a mesh: what a sharp edge may be off the mesh

/** @typedef {{positions: Float32Array, triangles: Uint32Array}} Mesh */

export class SolidEdges {
  /** @param {Mesh} mesh */
  constructor({ positions, triangles }) {
    this.positions = positions;
    const corners = weld(positions);
    const count = triangles.length / 3;
    this.normals = normalsOf(positions, triangles);
    /** Per edge: two corners, two faces (the second -1 where the mesh is open). @type {number[]} */
    this.edges = [];
    /** @type {Map<number, number>} */
    const known = new Map();
    for (let face = 0; face < count; ++face) {
      for (let side = 0; side < 3; ++side) {
        const a = triangles[3 * face + side];
        const b = triangles[3 * face + ((side + 1) % 3)];
        const [low, high] = corners[a] < corners[b] ? [corners[a], corners[b]] : [corners[b], corners[a]];
        const key = low * positions.length + high;
        const edge = known.get(key);
        if (edge == null) {
          known.set(key, this.edges.length);
          this.edges.push(a, b, face, -1);
        } else if (this.edges[edge + 3] < 0) {
          this.edges[edge + 3] = face;
        }
      }
    }
    this.sharp = joined(this.chosen((first, second) => second < 0 || this.turn(first, second) < SHARP), ROUND * sizeOf(positions));
    this.smooth = this.edges.length / 4 > 0 ? this.smoothEdges() : [];
  }

  /** @param {number} first @param {number} second faces; the cosine between their normals */
  turn(first, second) {
    const n = this.normals;
    return n[3 * first] * n[3 * second] + n[3 * first + 1] * n[3 * second + 1] + n[3 * first + 2] * n[3 * second + 2];
  }

  /** Edges between faces that bend by less than a sharp edge but are not one plane. */
  smoothEdges() {
    const smooth = [];
    for (let at = 0; at < this.edges.length; at += 4) {
      if (this.edges[at + 3] < 0) continue;
      const turn = this.turn(this.edges[at + 2], this.edges[at + 3]);
      if (turn >= SHARP && turn < 1 - 1e-9) smooth.push(at);
    }
    return smooth;
  }

  /** Ends of edges as x y z x y z. @param {(first: number, second: number) => boolean} wanted by their faces */
  chosen(wanted) {
    /** @type {number[]} */
    const ends = [];
    for (let at = 0; at < this.edges.length; at += 4) {
      if (wanted(this.edges[at + 2], this.edges[at + 3])) this.push(ends, at);
    }
    return ends;
  }

  /** @param {number[]} ends @param {number} at */
  push(ends, at) {
    for (const corner of [this.edges[at], this.edges[at + 1]]) {
      ends.push(this.positions[3 * corner], this.positions[3 * corner + 1], this.positions[3 * corner + 2]);
    }
  }

  /** Ends of the smooth edges where the surface turns away. @param {number[]} eye direction to the viewer */
  silhouette(eye) {
    const n = this.normals;
    const faces = (/** @type {number} */ face) => n[3 * face] * eye[0] + n[3 * face + 1] * eye[1] + n[3 * face + 2] * eye[2] > 0;
    /** @type {number[]} */
    const ends = [];
    for (const at of this.smooth) {
      if (faces(this.edges[at + 2]) !== faces(this.edges[at + 3])) this.push(ends, at);
    }
    return ends;
  }
}

/** The diagonal of the box about it. @param {Float32Array} positions */
function sizeOf(positions) {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  positions.forEach((value, n) => {
    low[n % 3] = Math.min(low[n % 3], value);
    high[n % 3] = Math.max(high[n % 3], value);
  });
  return Math.hypot(...high.map((value, axis) => value - low[axis])) || 0;
}

/** For each corner the first one of the same place. @param {Float32Array} positions */
function weld(positions) {
  const corners = new Uint32Array(positions.length / 3);
  /** @type {Map<string, number>} */
  const known = new Map();
  for (let n = 0; n < corners.length; ++n) {
    const key = `${Math.round(positions[3 * n] * WELD)} ${Math.round(positions[3 * n + 1] * WELD)} ${Math.round(positions[3 * n + 2] * WELD)}`;
    const first = known.get(key);
    if (first == null) known.set(key, n);
    corners[n] = first ?? n;
  }
  return corners;
}

/** Unit normals of the faces. @param {Float32Array} p @param {Uint32Array} triangles */
function normalsOf(p, triangles) {
  const normals = new Float32Array(triangles.length);
  for (let at = 0; at < triangles.length; at += 3) {
    const [a, b, c] = [3 * triangles[at], 3 * triangles[at + 1], 3 * triangles[at + 2]];
    const u = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const v = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(n[0], n[1], n[2]) || 1;
    for (let axis = 0; axis < 3; ++axis) normals[at + axis] = n[axis] / length;
  }
  return normals;
}

/**
 * A cylinder along Z as a closed mesh.
 * @param {number} diameter @param {number} from @param {number} until z of its ends
 * @returns {Mesh}
 */
export function cylinder(diameter, from, until) {
  const sides = 48;
  const positions = [];
  const triangles = [];
  for (let n = 0; n < sides; ++n) {
    const angle = (2 * Math.PI * n) / sides;
    const [x, y] = [(diameter / 2) * Math.cos(angle), (diameter / 2) * Math.sin(angle)];
    positions.push(x, y, from, x, y, until);
  }
  positions.push(0, 0, from, 0, 0, until);
  const [low, high] = [2 * sides, 2 * sides + 1];
  for (let n = 0; n < sides; ++n) {
    const [a, b] = [2 * n, 2 * ((n + 1) % sides)];
    triangles.push(a, b, b + 1, a, b + 1, a + 1, low, b, a, high, a + 1, b + 1);
  }
  return { positions: new Float32Array(positions), triangles: new Uint32Array(triangles) };
}
