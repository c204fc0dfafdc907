// What a plan view shows: a part, a plane, the touches in it, the outline of the part there and how it is scaled.
import { clamp } from './markup.js';
import { boundsOf, flat, frameOf, height } from './plan_planes.js';
import { circleOf, cutsOf, outlinesOf, roundOf } from './section.js';

/** @typedef {import('./types').Contact} Contact */
/** @typedef {import('./section').Flat} Flat */
/** @typedef {import('./plan_planes').Plane} Plane */
/** @typedef {{outline: Flat[], circle: {u: number, v: number, r: number} | null}} Wall */

const MAGNIFICATIONS = [20, 50, 100, 200, 500, 1000, 2000, 5000];
const IN_PLANE = 0.75; // of a normal's length; touches that look further out of the plane are not of it
const TOUCHING = 2.5; // radii of what touched that the view spans to either side at least
const AROUND = 1.83; // the view spans this much more than the contacts do
const SEEN = 5e-5; // mm; what is less is shown as 0.0 um
const FEW_DIRECTIONS = 0.2; // rad; touches closer together than that on a wall are one direction

/** @param {number[]} values not empty */
function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[sorted.length >> 1];
}

export class PlanView {
  /**
   * @param {import('./run').Run} run
   * @param {import('./types').Part} part
   * @param {Plane} plane
   */
  constructor(run, part, plane) {
    this.run = run;
    this.part = part;
    this.plane = plane;
    this.from = frameOf(part, run);
    this.bounds = boundsOf(part, plane);
    this.onPart = run.hits.filter(({ touch }) => touch.part === part.name);
    this.contacts = this.onPart.filter(({ normal }) => !normal || Math.abs(height(normal, plane)) < IN_PLANE);
    const crash = run.collision;
    this.crash = crash && crash.contact && (crash.part === part.name || crash.part == null) ? crash : null;
    const heights = (this.contacts.length ? this.contacts : this.onPart).map(({ place }) => height(place ?? [0, 0, 0], plane));
    if (this.crash?.contact && !heights.length) heights.push(height(this.crash.contact, plane));
    const [bottom, top] = [this.bounds.low[2], this.bounds.high[2]];
    const wanted = heights.length ? median(heights) : (bottom + top) / 2;
    // Just below the top, where the touches are on it: there the outline is that of the material.
    this.height = clamp(wanted, bottom + 1e-3 * (top - bottom), top - 1e-3 * (top - bottom));
    this.walls = this.wallsAt();
    this.measured = this.measuredCircles();
    this.frame = this.frameOf();
    this.magnification = this.magnificationOf();
  }

  /** @returns {Wall[]} */
  wallsAt() {
    const { plane, part } = this;
    const cuts = cutsOf(part, plane.out, this.height);
    /** @type {Flat[]} */
    const ends = [];
    for (let n = 0; n < cuts.length; n += 3) ends.push(flat(cuts.slice(n, n + 3), plane));
    return outlinesOf(ends).map((outline) => ({ outline, circle: roundOf(outline) }));
  }

  /** The round wall that a point lies on. @param {Flat} point */
  wallAt(point) {
    /** @type {Wall | null} */
    let nearest = null;
    let least = Infinity;
    for (const wall of this.walls) {
      if (!wall.circle) continue;
      const { u, v, r } = wall.circle;
      const apart = Math.abs(Math.hypot(point[0] - u, point[1] - v) - r);
      if (apart < least && apart < 0.02 * r + 0.05) [nearest, least] = [wall, apart];
    }
    return nearest;
  }

  /** Circles through what was measured of round walls with touches from three or more directions. */
  measuredCircles() {
    /** @type {Map<Wall, Contact[]>} */
    const byWall = new Map();
    for (const contact of this.contacts) {
      if (!contact.counts || contact.deviation == null || !contact.place) continue;
      const wall = this.wallAt(flat(contact.place, this.plane));
      if (wall) byWall.set(wall, [...(byWall.get(wall) ?? []), contact]);
    }
    const circles = [];
    for (const [{ circle: truth }, contacts] of byWall) {
      if (!truth) continue;
      const angles = contacts.map(({ place }) => {
        const [u, v] = flat(place ?? [], this.plane);
        return Math.atan2(v - truth.v, u - truth.u);
      }).sort((a, b) => a - b);
      const directions = angles.filter((angle, n) => n === 0 || angle - angles[n - 1] > FEW_DIRECTIONS).length;
      const points = contacts.map((contact) => this.measuredPoint(contact, truth));
      const circle = directions >= 3 ? circleOf(points) : null;
      if (circle) circles.push({ truth, circle });
    }
    return circles;
  }

  /** Where the measurement puts the wall: on the true circle (a mesh is a polygon), deeper by the deviation.
   * @param {Contact} contact @param {{u: number, v: number, r: number}} truth @returns {Flat} */
  measuredPoint(contact, truth) {
    const [u, v] = flat(contact.place ?? [], this.plane);
    const [nu, nv] = flat(contact.normal ?? [], this.plane);
    const length = Math.hypot(u - truth.u, v - truth.v);
    const deviation = (contact.deviation ?? 0) + (contact.partDeviation ?? 0);
    return [truth.u + ((u - truth.u) / length) * truth.r - nu * deviation,
      truth.v + ((v - truth.v) / length) * truth.r - nv * deviation];
  }

  /** Centre and half the span of the view, mm. */
  frameOf() {
    const { plane } = this;
    const { low, high } = this.bounds;
    // What only stands there, a beam of half a metre, is seen where it was touched, from whichever side.
    const shown = this.contacts.length || !this.part.fixture ? this.contacts : this.onPart;
    const points = shown.map(({ place }) => flat(place ?? [], plane));
    if (this.crash?.contact) points.push(flat(this.crash.contact, plane));
    for (const { circle } of this.measured) {
      points.push([circle.u - circle.r, circle.v - circle.r], [circle.u + circle.r, circle.v + circle.r]);
    }
    const whole = Math.max(high[0] - low[0], high[1] - low[1]) / 2;
    if (!points.length) return { u: (low[0] + high[0]) / 2, v: (low[1] + high[1]) / 2, half: 1.1 * whole };
    if (this.crash) {
      const wall = this.nearestRound(points[0]);
      if (wall) points.push([wall.u - wall.r, wall.v - wall.r], [wall.u + wall.r, wall.v + wall.r]);
      const origin = flat(this.from.origin, plane);
      const isOfFrame = wall && Math.hypot(wall.u - origin[0], wall.v - origin[1]) < 1.2 * wall.r;
      if (isOfFrame) points.push(origin);
    }
    const us = points.map((p) => p[0]);
    const vs = points.map((p) => p[1]);
    const span = Math.max(Math.max(...us) - Math.min(...us), Math.max(...vs) - Math.min(...vs)) / 2;
    const ball = this.run.figures.probe?.ball ?? 0;
    const largest = Math.max(0, ...shown.map(({ radius }) => radius)); // of tools, too
    const half = Math.max(span * (this.crash ? 1.35 : AROUND), 4 * ball, TOUCHING * largest, 0.4 * Math.min(whole, 50));
    return { u: (Math.min(...us) + Math.max(...us)) / 2, v: (Math.min(...vs) + Math.max(...vs)) / 2, half };
  }

  /** @param {Flat} point */
  nearestRound(point) {
    const circles = this.walls.map(({ circle }) => circle).filter((circle) => circle != null);
    const apart = (/** @type {{u: number, v: number, r: number}} */ c) => Math.abs(Math.hypot(point[0] - c.u, point[1] - c.v) - c.r);
    return circles.sort((a, b) => apart(a) - apart(b))[0] ?? null;
  }

  /** So that the largest whisker is about a quarter of the outline, or of what is seen of a larger one; null
   * where no touch deviates. */
  magnificationOf() {
    const largest = Math.max(0, ...this.contacts.map(({ deviation, partDeviation }) => Math.max(
      Math.abs(deviation ?? 0), Math.abs((deviation ?? 0) + (partDeviation ?? 0)))));
    if (largest < SEEN) return null;
    const room = Math.min(0.29 * this.frame.half, ...this.measured.map(({ truth }) => 0.52 * truth.r));
    return MAGNIFICATIONS.filter((factor) => largest * factor <= room).pop() ?? MAGNIFICATIONS[0];
  }
}
