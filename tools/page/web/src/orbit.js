// How the scene is looked at: a parallel projection that turns about its centre, Z up.
import { clamp } from './markup.js';
import { dot } from './vectors.js';

const ISO = { azimuth: -124, elevation: 27 }; // degrees; the viewer stands at the front, to the left
const VIEWS = { iso: ISO, x: { azimuth: 0, elevation: 0 }, y: { azimuth: -90, elevation: 0 }, z: { azimuth: -90, elevation: 90 } };
const MARGIN = 1.12;

/** @typedef {keyof typeof VIEWS} ViewName */

export class Orbit {
  /** @param {import('./types').Box} box what is to be seen */
  constructor(box) {
    this.box = box;
    this.azimuth = ISO.azimuth;
    this.elevation = ISO.elevation;
    this.width = 600;
    this.height = 480;
    this.zoom = 1;
    this.centre = [0, 1, 2].map((axis) => (box.low[axis] + box.high[axis]) / 2);
    this.fit();
  }

  get eye() {
    const [a, e] = [(this.azimuth * Math.PI) / 180, (this.elevation * Math.PI) / 180];
    return [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
  }

  get right() {
    const a = (this.azimuth * Math.PI) / 180;
    return [-Math.sin(a), Math.cos(a), 0];
  }

  get up() {
    const [a, e] = [(this.azimuth * Math.PI) / 180, (this.elevation * Math.PI) / 180];
    return [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)];
  }

  /** mm a px. */
  get pixel() {
    return 1 / this.zoom;
  }

  /** All of the box in sight. */
  fit() {
    const { low, high } = this.box;
    let [left, right, down, up] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let corner = 0; corner < 8; ++corner) {
      const at = [0, 1, 2].map((axis) => (corner & (1 << axis) ? high[axis] : low[axis]));
      const [x, y] = [dot(at, this.right), dot(at, this.up)];
      left = Math.min(left, x);
      right = Math.max(right, x);
      down = Math.min(down, y);
      up = Math.max(up, y);
    }
    this.zoom = Math.min(this.width / (right - left || 1), this.height / (up - down || 1)) / MARGIN;
    const middle = [0, 1, 2].map((axis) => (low[axis] + high[axis]) / 2);
    const [dx, dy] = [(left + right) / 2 - dot(middle, this.right), (down + up) / 2 - dot(middle, this.up)];
    this.centre = middle.map((value, axis) => value + dx * this.right[axis] + dy * this.up[axis]);
  }

  /** @param {ViewName} name */
  look(name) {
    Object.assign(this, VIEWS[name]);
    this.fit();
  }

  /** @param {number} right degrees @param {number} up degrees */
  turn(right, up) {
    this.azimuth = (this.azimuth - right) % 360;
    this.elevation = clamp(this.elevation + up, -89, 90);
  }

  /** @param {number} dx px @param {number} dy px */
  pan(dx, dy) {
    const { right, up, pixel } = this;
    this.centre = this.centre.map((value, axis) => value - (dx * right[axis] - dy * up[axis]) * pixel);
  }

  /** @param {number} factor over 1 comes nearer */
  come(factor) {
    this.zoom = clamp(this.zoom * factor, 1e-3, 1e4);
  }

  /** px from the left and from above. @param {number[]} point @returns {[number, number]} */
  project(point) {
    const from = [0, 1, 2].map((axis) => point[axis] - this.centre[axis]);
    return [this.width / 2 + dot(from, this.right) * this.zoom, this.height / 2 - dot(from, this.up) * this.zoom];
  }
}
