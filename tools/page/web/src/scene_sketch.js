// The scene without WebGL: edges, ways and the ball as lines.
import { piecesOf } from './scene_content.js';

/** @param {number[]} ends @param {import('./orbit').Orbit} orbit @param {number[]} [origin] */
function path(ends, orbit, origin = [0, 0, 0]) {
  let d = '';
  for (let n = 0; n < ends.length; n += 3) {
    const [x, y] = orbit.project([ends[n] + origin[0], ends[n + 1] + origin[1], ends[n + 2] + origin[2]]);
    d += `${n % 6 ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
  }
  return d;
}

export class SceneSketch {
  /** @param {HTMLElement} box @param {import('./run').Run} run @param {import('./scene_content').Solid[]} solids */
  constructor(box, run, solids) {
    this.run = run;
    this.solids = solids;
    this.pieces = { rapid: piecesOf(run, 'rapid'), feed: piecesOf(run, 'feed'), skip: piecesOf(run, 'skip') };
    box.insertAdjacentHTML('afterbegin', '<svg id="scene" class="fig" role="img" tabindex="0"></svg>');
    this.svg = /** @type {SVGElement} */ (box.firstElementChild);
  }

  /** @param {import('./orbit').Orbit} orbit @param {number} time s */
  draw(orbit, time) {
    const edges = this.solids.map(({ part, edges: own }) =>
      path([...own.sharp, ...own.silhouette(orbit.eye)], orbit, part.origin)).join('');
    const ways = Object.entries(this.pieces).map(([kind, pieces]) => `<path d="${path(pieces, orbit)}" fill="none" stroke="var(--${kind})" `
      + `stroke-width="${kind === 'skip' ? 2.4 : 1.7}"${kind === 'rapid' ? ' stroke-dasharray="6 4"' : ''}/>`).join('');
    const balls = this.run.ballsAt(time).map(({ at, radius }) => {
      const [x, y] = orbit.project(at);
      return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="${(radius * orbit.zoom).toFixed(1)}" fill="var(--paper)" stroke="var(--skip)" stroke-width="2"/>`;
    });
    this.svg.setAttribute('viewBox', `0 0 ${orbit.width} ${orbit.height}`);
    this.svg.innerHTML = `<path d="${edges}" fill="none" stroke="var(--ink3)"/>${ways}${balls.join('')}`;
  }
}
