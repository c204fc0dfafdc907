// Lines of the scene, of constant width on the screen.
import { Color, Plane, Vector3 } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

/** @typedef {{role: string, width: number, dashes?: [number, number], above?: boolean, opacity?: number}} Look px */

export class SceneLines {
  /** @param {import('three').Object3D} holder @param {Look} look @param {number[]} origin that the ends are given from */
  constructor(holder, look, origin) {
    this.look = look;
    this.origin = origin;
    this.material = new LineMaterial({ linewidth: look.width, dashed: look.dashes != null, transparent: look.opacity != null });
    if (look.opacity != null) this.material.opacity = look.opacity;
    if (look.dashes) [this.material.dashSize, this.material.gapSize] = look.dashes;
    if (look.above) this.material.depthTest = false;
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = look.above ? 2 : 1;
    holder.add(this.object);
  }

  /** @param {number[]} ends x y z x y z, from the origin */
  set(ends) {
    this.object.visible = ends.length > 0;
    if (!ends.length) return;
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry();
    this.object.geometry.setPositions(new Float32Array(ends));
    if (this.look.dashes) this.object.computeLineDistances();
  }

  /** Ends in machine coordinates, brought near the origin, where single precision is enough. @param {number[]} ends */
  setAbsolute(ends) {
    this.set(ends.map((value, n) => value - this.origin[n % 3]));
  }

  /** Leaves out what lies within a wedge. @param {number[] | null} apex null: nothing @param {number[][]} wedge */
  cut(apex, wedge) {
    this.material.clipping = apex != null;
    this.material.clipIntersection = true;
    this.material.clippingPlanes = apex
      ? wedge.map((normal) => new Plane().setFromNormalAndCoplanarPoint(new Vector3(...normal).negate(), new Vector3(...apex))) : [];
  }

  /** @param {(name: string) => string} ink @param {number} pixel mm */
  paint(ink, pixel) {
    this.material.color = new Color(ink(this.look.role));
    this.material.dashScale = 1 / pixel;
  }
}
