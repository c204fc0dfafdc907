// The scene as three.js draws it: once for each change, never by itself.
import {
  BufferAttribute, BufferGeometry, Group, Mesh, OrthographicCamera, Scene as Stage, SphereGeometry, Vector3, WebGLRenderer,
} from 'three';
import { cutOutlines, piecesOf, placesOf, stylusOf, wedgeOf } from './scene_content.js';
import { SceneLines } from './scene_lines.js';
import { ballMaterial, paintBall, paintSolid, solidMaterial } from './scene_material.js';
import { UPRIGHT, turnedBack } from './turn.js';

const DASHES = /** @type {[number, number]} */ ([6, 4]);
const WAYS = { rapid: { role: 'rapid', width: 1.7, dashes: DASHES }, feed: { role: 'feed', width: 1.8 }, skip: { role: 'skip', width: 2.4 } };
const NORMAL = 0.09; // length of a normal, of the scene's height

/** @typedef {import('./scene_content').Solid} Solid */

export class SceneGl {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import('./run').Run} run
   * @param {Solid[]} solids
   * @param {import('./run').Run | null} other
   * @throws where there is no WebGL
   */
  constructor(canvas, run, solids, other) {
    this.run = run;
    // Kept after drawing, so that pictures of the page and paper have it.
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.localClippingEnabled = true;
    this.stage = new Stage();
    this.camera = new OrthographicCamera();
    this.camera.up.set(0, 0, 1);
    /** @type {SceneLines[]} */
    this.lines = [];
    this.solids = solids.map((solid) => this.addSolid(solid));
    this.addWays(run, other);
    this.addContacts();
    this.stylus = this.addStylus();
    this.isOpen = true;
    this.eyeShown = '';
    this.turn = UPRIGHT;
  }

  /** @param {import('three').Object3D} holder @param {import('./scene_lines').Look} look @param {number[]} [origin] */
  line(holder, look, origin = [0, 0, 0]) {
    const lines = new SceneLines(holder, look, origin);
    this.lines.push(lines);
    return lines;
  }

  /** @param {Solid} solid */
  addSolid(solid) {
    const { part, edges } = solid;
    const group = new Group();
    group.position.set(part.origin[0], part.origin[1], part.origin[2]);
    const material = solidMaterial([part.box.low[2], part.box.high[2]]);
    group.add(meshOf(part, material));
    this.stage.add(group);
    const sharp = this.line(group, { role: 'ink2', width: 1.2 });
    const ghost = this.line(group, { role: 'ink3', width: 0.8, opacity: 0.22 });
    sharp.set(edges.sharp);
    ghost.set(edges.sharp);
    return { solid, material, sharp, ghost, turns: this.line(group, { role: 'ink2', width: 1.2 }),
      cut: this.line(group, { role: 'ink2', width: 1.2 }, part.origin) };
  }

  /** @param {import('./run').Run} run @param {import('./run').Run | null} other */
  addWays(run, other) {
    const origin = run.frame.origin;
    const group = new Group();
    group.position.set(origin[0], origin[1], origin[2]);
    this.stage.add(group);
    for (const kind of /** @type {import('./types').Kind[]} */ (['rapid', 'feed', 'skip'])) {
      this.line(group, WAYS[kind], origin).setAbsolute(piecesOf(run, kind));
    }
    if (other) this.line(group, { role: 'accent', width: 1.4, dashes: [3, 4] }, origin).setAbsolute(piecesOf(other, null));
    this.group = group;
  }

  /** Normals at the contacts, and deviations magnified along them. */
  addContacts() {
    const { origin } = this.run.frame;
    this.normals = this.line(/** @type {Group} */ (this.group), { role: 'ink', width: 1.5 }, origin);
    this.whiskers = this.line(/** @type {Group} */ (this.group), { role: 'accent', width: 4, above: true }, origin);
    this.places = placesOf(this.run);
  }

  addStylus() {
    const group = new Group();
    const { probe } = this.run.figures;
    const main = { at: [0, 0, 0], diameter: probe?.ball ?? 0 };
    const balls = [main, ...(probe?.further ?? [])].filter(({ diameter }) => diameter > 0).map(({ at, diameter }) => {
      const material = ballMaterial();
      const mesh = new Mesh(new SphereGeometry(diameter / 2, 48, 32), material);
      mesh.position.set(at[0], at[1], at[2]);
      group.add(mesh);
      return { material, radius: diameter / 2 };
    });
    const pieces = stylusOf(this.run).map((piece) => {
      const material = solidMaterial([-1e6, -1e6 + 1]);
      group.add(meshOf(piece, material));
      const sharp = this.line(group, { role: 'ink2', width: 1.1 });
      sharp.set(piece.edges.sharp);
      return { piece, material, turns: this.line(group, { role: 'ink2', width: 1.1 }) };
    });
    this.stage.add(group);
    return { group, balls, pieces };
  }

  /** Contacts as long as the scale wants them. @param {import('./orbit').Orbit} orbit @param {number} magnification */
  scaleContacts(orbit, magnification) {
    const long = NORMAL * orbit.height * orbit.pixel;
    /** @type {number[]} */
    const normals = [];
    /** @type {number[]} */
    const whiskers = [];
    for (const { place, normal, deviation } of this.places ?? []) {
      if (!place || !normal) continue;
      const tip = place.map((value, axis) => value + normal[axis] * long);
      normals.push(...place, ...tip, ...barbs(tip, normal, 0.22 * long));
      if (deviation) whiskers.push(...place, ...place.map((value, axis) => value - normal[axis] * deviation * magnification));
    }
    this.normals?.setAbsolute(normals);
    this.whiskers?.setAbsolute(whiskers);
  }

  /** @param {import('./orbit').Orbit} orbit @param {number} ratio px of the device a px */
  resize(orbit, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(orbit.width, orbit.height, false);
  }

  /** @param {import('./orbit').Orbit} orbit */
  aim(orbit) {
    const { eye, centre, width, height, pixel } = orbit;
    const { low, high } = orbit.box;
    const far = 4 * Math.hypot(...high.map((value, axis) => value - low[axis])) + 400;
    Object.assign(this.camera, { left: (-width / 2) * pixel, right: (width / 2) * pixel, top: (height / 2) * pixel,
      bottom: (-height / 2) * pixel, near: 0, far: 2 * far });
    const [ux, uy, uz] = orbit.up;
    this.camera.up.set(ux, uy, uz);
    this.camera.position.set(centre[0] + eye[0] * far, centre[1] + eye[1] * far, centre[2] + eye[2] * far);
    this.camera.lookAt(centre[0], centre[1], centre[2]);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    return far;
  }

  /** @param {import('./orbit').Orbit} orbit @param {number} far */
  open(orbit, far) {
    const wedge = wedgeOf(orbit.azimuth);
    const uniforms = { eye: new Vector3(...orbit.eye), pixel: orbit.pixel, bias: (1.2 * orbit.pixel) / (2 * far) };
    const eyeNow = `${orbit.azimuth} ${orbit.elevation} ${this.isOpen} ${this.turn.join()}`;
    for (const { solid, material, sharp, ghost, turns, cut } of this.solids) {
      const apex = this.isOpen ? solid.apex : null;
      set(material, uniforms);
      material.uniforms.isOpen.value = apex ? 1 : 0;
      if (apex) material.uniforms.apex.value.set(apex[0], apex[1], apex[2]);
      material.uniforms.first.value.set(wedge[0][0], wedge[0][1]);
      material.uniforms.second.value.set(wedge[1][0], wedge[1][1]);
      if (eyeNow === this.eyeShown) continue;
      ghost.object.visible = apex != null;
      for (const lines of [sharp, turns]) lines.cut(apex, wedge);
      turns.set(solid.edges.silhouette(orbit.eye));
      cut.setAbsolute(apex ? cutOutlines(solid, wedge) : []);
    }
    for (const { piece, material, turns } of this.stylus.pieces) {
      set(material, uniforms);
      if (eyeNow !== this.eyeShown) turns.set(piece.edges.silhouette(turnedBack(orbit.eye, this.turn)));
    }
    for (const { material, radius } of this.stylus.balls) set(material, { eye: uniforms.eye, radius: radius * orbit.zoom });
    this.eyeShown = eyeNow;
  }

  /** @param {import('./orbit').Orbit} orbit @param {number} time s @param {(name: string) => string} ink */
  draw(orbit, time, ink) {
    this.turn = this.run.turnAt(time);
    this.open(orbit, this.aim(orbit));
    const ball = this.run.ballAt(time);
    this.stylus.group.visible = ball != null;
    if (ball) this.stylus.group.position.set(ball[0], ball[1], ball[2]);
    const [x, y, z, w] = this.turn;
    this.stylus.group.quaternion.set(x, y, z, w);
    for (const { material } of [...this.solids, ...this.stylus.pieces]) paintSolid(material, ink);
    for (const { material } of this.stylus.balls) paintBall(material, ink, this.run.kindAt(time) === 'collision');
    for (const lines of this.lines) lines.paint(ink, orbit.pixel);
    this.renderer.render(this.stage, this.camera);
  }
}

/** @param {import('three').ShaderMaterial} material @param {Record<string, unknown>} values */
function set(material, values) {
  for (const [name, value] of Object.entries(values)) material.uniforms[name].value = value;
}

/** @param {{positions: Float32Array, triangles: Uint32Array}} solid @param {import('three').ShaderMaterial} material */
function meshOf({ positions, triangles }, material) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

/** Two barbs of an arrow. @param {number[]} tip @param {number[]} along unit @param {number} long */
function barbs(tip, along, long) {
  const across = Math.abs(along[2]) > 0.9 ? [1, 0, 0] : [-along[1], along[0], 0];
  return [1, -1].flatMap((side) => [...tip, ...tip.map((value, axis) => value - long * (along[axis] - 0.45 * side * across[axis]))]);
}
