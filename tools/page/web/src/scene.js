// The scene: what stands where, how the probe got there; looked at from any side.
import { byId, clamp, esc } from './markup.js';
import { Orbit } from './orbit.js';
import { boxOf, placesOf, solidsOf } from './scene_content.js';
import { SceneGl } from './scene_gl.js';
import { SceneLabels } from './scene_labels.js';
import { SceneSketch } from './scene_sketch.js';
import { word } from './words.js';

const TURN = 8; // degrees a key
const DRAG = 4; // px that a pointer moves before it drags
const MAGNIFICATIONS = [20, 50, 100, 200, 500, 1000, 2000];
const PAPER_RATIO = 3; // px of the picture on paper a px of its layout

export class Scene {
  /** @param {import('./choice').Choice} choice @param {import('./types').Part[]} parts
   * @param {import('./run').Run | null} other */
  constructor(choice, parts, other) {
    this.choice = choice;
    this.parts = parts;
    this.other = other;
    this.box = byId('scenebox');
  }

  /** Builds the scene: behind the rest of the page, for compiling its shaders takes longer than all else. */
  start() {
    const { choice, parts, other } = this;
    if (!this.box || this.orbit || (!parts.length && !choice.run.ways.length)) return;
    this.solids = solidsOf(parts, choice.run);
    this.places = placesOf(choice.run);
    this.orbit = new Orbit(boxOf(parts, choice.run));
    this.box.innerHTML = '';
    this.painter = this.painterFor(other);
    this.labels = new SceneLabels(this.box, choice, this.solids, this.places);
    const view = this.box.firstElementChild;
    view?.setAttribute('aria-label', word('scene_aria'));
    this.addTools();
    this.linkPointer(/** @type {HTMLElement} */ (view));
    addEventListener('keydown', (event) => this.key(event));
    choice.listen((change) => (change === 'size' ? this.resize() : this.request()));
    this.resize();
  }

  /** WebGL, else a sketch. @param {import('./run').Run | null} other @returns {SceneGl | SceneSketch} */
  painterFor(other) {
    const box = /** @type {HTMLElement} */ (this.box);
    const canvas = document.createElement('canvas');
    canvas.id = 'scene';
    canvas.className = 'fig';
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    try {
      if (!canvas.getContext('webgl2', { antialias: true, alpha: true, preserveDrawingBuffer: true })) throw new Error('no WebGL');
      const painter = new SceneGl(canvas, this.choice.run, this.solids ?? [], other);
      box.prepend(canvas);
      return painter;
    } catch {
      const sketch = new SceneSketch(box, this.choice.run, this.solids ?? []);
      box.insertAdjacentHTML('beforeend', `<p class="no-webgl">${esc(word('no_webgl'))}</p>`);
      return sketch;
    }
  }

  addTools() {
    const box = /** @type {HTMLElement} */ (this.box);
    const views = ['iso', 'x', 'y', 'z', 'fit'].map((name) => `<button data-view="${name}">`
      + `${esc(word(/** @type {'view_x'} */ (`view_${name}`)))}</button>`).join('');
    const isGl = this.painter instanceof SceneGl && this.solids?.some(({ apex }) => apex);
    const section = isGl ? `<button data-view="section" aria-pressed="true">${esc(word('section'))}</button>` : '';
    box.insertAdjacentHTML('beforeend', `<div class="seg scene-tools noprint" role="group" aria-label="${esc(word('view'))}">${views}${section}</div>`);
    box.querySelector('.scene-tools')?.addEventListener('click', (event) => {
      const button = /** @type {HTMLElement | null} */ (/** @type {Element} */ (event.target).closest('button'));
      const name = button?.dataset.view;
      if (!name || !this.orbit) return;
      if (name === 'section') this.toggleSection(/** @type {HTMLElement} */ (button));
      else if (name === 'fit') this.orbit.fit();
      else this.orbit.look(/** @type {import('./orbit').ViewName} */ (name));
      this.request();
    });
  }

  /** @param {HTMLElement} button */
  toggleSection(button) {
    if (!(this.painter instanceof SceneGl)) return;
    this.painter.isOpen = !this.painter.isOpen;
    button.setAttribute('aria-pressed', String(this.painter.isOpen));
  }

  /** Numbers of touches lie above the scene: what is done to them is done to it, but for a click. @param {HTMLElement} view */
  linkPointer(view) {
    const box = /** @type {HTMLElement} */ (this.box);
    const isTool = (/** @type {Event} */ event) => /** @type {Element} */ (event.target).closest('.scene-tools') != null;
    /** @type {Map<number, {x: number, y: number}>} */
    const down = new Map();
    box.addEventListener('mousedown', (event) => {
      if (isTool(event)) return;
      event.preventDefault(); // no text is selected, and the number takes no focus away
      view.focus({ preventScroll: true });
    });
    box.addEventListener('pointerdown', (event) => {
      if (!isTool(event)) down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    });
    for (const end of ['pointerup', 'pointercancel']) {
      addEventListener(end, (event) => down.delete(/** @type {PointerEvent} */ (event).pointerId));
    }
    box.addEventListener('pointermove', (event) => this.drag(down, event));
    // A wheel scrolls the page; it zooms the scene that has the focus, and with the control key, as a pinch does.
    box.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && document.activeElement !== view) return;
      event.preventDefault();
      this.orbit?.come(Math.exp(-event.deltaY * 0.0015));
      this.request();
    }, { passive: false });
    box.addEventListener('contextmenu', (event) => event.preventDefault());
    view.addEventListener('dblclick', () => {
      this.orbit?.fit();
      this.request();
    });
  }

  /** @param {Map<number, {x: number, y: number}>} down where pointers were @param {PointerEvent} event */
  drag(down, event) {
    const box = /** @type {HTMLElement} */ (this.box);
    const before = down.get(event.pointerId);
    if (!before || !this.orbit) return;
    const [dx, dy] = [event.clientX - before.x, event.clientY - before.y];
    // The click of a captured pointer is the box's: a hand that trembles still chooses the number that it is on.
    if (!box.hasPointerCapture(event.pointerId)) {
      if (Math.hypot(dx, dy) < DRAG) return;
      box.setPointerCapture(event.pointerId);
    }
    const others = [...down].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    if (others.length) this.pinch(before, event, others[0]);
    else if (event.shiftKey || event.buttons === 2) this.orbit.pan(dx, dy);
    else this.orbit.turn(dx * 0.4, event.pointerType === 'touch' ? 0 : dy * 0.4);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.request();
  }

  /** @param {{x: number, y: number}} before @param {PointerEvent} now @param {{x: number, y: number}} other */
  pinch(before, now, other) {
    const was = Math.hypot(before.x - other.x, before.y - other.y);
    const is = Math.hypot(now.clientX - other.x, now.clientY - other.y);
    if (was > 0 && is > 0) this.orbit?.come(is / was);
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (document.activeElement?.id !== 'scene' || !this.orbit || event.ctrlKey || event.metaKey || event.altKey) return;
    const turns = { ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, TURN], ArrowDown: [0, -TURN] };
    const turn = turns[/** @type {keyof typeof turns} */ (event.key)];
    if (turn) this.orbit.turn(turn[0], turn[1]);
    else if (event.key === '+' || event.key === '=') this.orbit.come(1.2);
    else if (event.key === '-') this.orbit.come(1 / 1.2);
    else return;
    event.preventDefault();
    this.request();
  }

  /** @param {number} [width] px @param {number} [share] @param {number} [ratio] */
  resize(width, share = 0.82, ratio = devicePixelRatio) {
    if (!this.box || !this.orbit) return;
    const { orbit } = this;
    orbit.width = width ?? Math.max(260, Math.round(this.box.clientWidth || 600));
    orbit.height = Math.round(clamp(orbit.width * share, 300, 540));
    this.box.style.setProperty('--shape', `${orbit.width} / ${orbit.height}`);
    orbit.fit();
    const largest = Math.max(1e-4, ...(this.places ?? []).map(({ deviation }) => Math.abs(deviation ?? 0)));
    const room = 0.07 * orbit.height * orbit.pixel;
    this.magnification = MAGNIFICATIONS.filter((factor) => largest * factor < room).pop() ?? MAGNIFICATIONS[0];
    if (this.painter instanceof SceneGl) {
      this.painter.resize(orbit, Math.min(ratio, PAPER_RATIO));
      this.painter.scaleContacts(orbit, this.magnification);
    }
    this.draw();
  }

  /** Draws with the next picture of the browser, once for all that has changed until then. */
  request() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.draw();
    });
  }

  draw() {
    if (!this.orbit) return;
    const style = getComputedStyle(document.documentElement);
    this.painter?.draw(this.orbit, this.choice.time, (name) => style.getPropertyValue(`--${name}`).trim());
    this.labels?.draw(this.orbit, this.magnification ?? 1);
  }

  /** A picture takes the place of the canvas. @param {number} width px @param {number} share */
  beforePrint(width, share) {
    this.start();
    this.resize(width, share, PAPER_RATIO);
    if (!(this.painter instanceof SceneGl)) return;
    const canvas = this.painter.renderer.domElement;
    this.picture = new Image();
    this.picture.src = canvas.toDataURL('image/png');
    this.picture.className = 'fig scene-picture';
    this.picture.alt = word('scene_aria');
    canvas.hidden = true;
    canvas.after(this.picture);
  }

  afterPrint() {
    this.picture?.remove();
    if (this.painter instanceof SceneGl) this.painter.renderer.domElement.hidden = false;
    this.resize();
  }
}
