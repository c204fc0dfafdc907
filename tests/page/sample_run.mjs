// A run in closed form, with meshes, as documents of the command: a bore and a pin, each touched from four sides,
// fast and slow; what the page must show of it is known without running anything.

export const BORE = { u: 150, v: 80, r: 20.0105 };
export const PIN = { u: 230, v: 80, r: 6 };
export const BALL = 6;
const FRAME = [150, 80, -300];
const DEPTH = -305; // of the touches
const SAFE = -270;
const DEVIATION = { fast: 0.0123, slow: 0.0042 }; // mm into the wall
const MODEL_SIZE = 0.0105; // the bore is that much over 20 mm

/** @param {Float32Array | Uint32Array} array */
const base64 = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString('base64');

/** A block with a round bore through it; origin in the middle of its top. */
function bored(half, depth, r, sides = 96) {
  const positions = [];
  const triangles = [];
  for (let n = 0; n < sides; ++n) {
    const angle = (2 * Math.PI * (n + 0.5)) / sides;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const out = half / Math.max(Math.abs(c), Math.abs(s));
    for (const z of [0, -depth]) positions.push(r * c, r * s, z, out * c, out * s, z);
  }
  for (let n = 0; n < sides; ++n) {
    const [a, b] = [4 * n, 4 * ((n + 1) % sides)]; // inner top, outer top, inner foot, outer foot
    const quad = (p, q, r_, s_) => triangles.push(p, q, r_, p, r_, s_);
    quad(a, a + 1, b + 1, b);
    quad(a + 2, b + 2, b + 3, a + 3);
    quad(a, b, b + 2, a + 2);
    quad(a + 1, a + 3, b + 3, b + 1);
  }
  return { positions, triangles };
}

/** A pin on a square plate. */
function pinned(half, thick, r, high, sides = 64) {
  const positions = [];
  const triangles = [];
  const x = [-half, half];
  for (const z of [-thick, 0]) for (const v of x) for (const u of x) positions.push(u, v, z);
  const quad = (a, b, c, d) => triangles.push(a, b, c, a, c, d);
  quad(0, 2, 3, 1);
  quad(4, 5, 7, 6);
  quad(0, 1, 5, 4);
  quad(2, 6, 7, 3);
  quad(0, 4, 6, 2);
  quad(1, 3, 7, 5);
  for (let n = 0; n < sides; ++n) {
    const angle = (2 * Math.PI * n) / sides;
    positions.push(r * Math.cos(angle), r * Math.sin(angle), 0, r * Math.cos(angle), r * Math.sin(angle), high);
  }
  const centre = positions.length / 3;
  positions.push(0, 0, high);
  for (let n = 0; n < sides; ++n) {
    const [a, b] = [8 + 2 * n, 8 + 2 * ((n + 1) % sides)];
    triangles.push(a, b, b + 1, a, b + 1, a + 1, centre, a + 1, b + 1);
  }
  return { positions, triangles };
}

/** Collects moves, ways, touches as the ball goes. */
class Tape {
  constructor(shift) {
    this.shift = shift;
    this.time = 0;
    this.ball = [BORE.u, BORE.v, -200];
    this.moves = [];
    this.ways = [];
    this.touches = [];
    this.figures = [];
  }

  go(g, to, speed, line, file = 'O9010.nc') {
    const long = Math.hypot(...to.map((v, axis) => v - this.ball[axis]));
    const from = this.time;
    this.time += long / speed + 0.02;
    const kind = g === 0 ? 'rapid' : g === 31 ? 'skip' : 'feed';
    const points = [0, 0.5, 1].flatMap((share) => to.map((v, axis) => this.ball[axis] + share * (v - this.ball[axis])));
    this.ways.push({ move: this.moves.length, kind, time_s: [from, this.time], points });
    this.moves.push({ g, to: [to[0], to[1], to[2] + 120], feed: g ? speed * 60 : undefined, time_s: this.time, file, line });
    this.ball = to;
  }

  /** A skip move along -normal to a wall at contact. */
  touch(part, contact, normal, deviation, feed, line, role) {
    const ball = contact.map((v, axis) => v + normal[axis] * (BALL / 2 - deviation) + (axis < 2 ? 0 : 0));
    const commanded = ball.map((v, axis) => v - normal[axis] * 4);
    this.go(31, ball, feed / 60, line);
    const work = ball.map((v, axis) => v - FRAME[axis]);
    this.touches.push({ block: 'G31', file: 'O9010.nc', line, triggered: true, commanded, latched: ball, stopped: ball,
      work, contact, normal, part, feed, time_s: this.time, tool: 1, calls: [{ program: 'O0001', file: 'main.nc', line: 4 }] });
    this.figures.push({ ball, deviation, angle: 0, role });
  }

  miss(to, line) {
    this.go(31, to, 10, line);
    this.touches.push({ block: 'G31', file: 'O9010.nc', line, triggered: false, commanded: to, latched: to, stopped: to,
      work: to.map((v, axis) => v - FRAME[axis]), contact: null, normal: null, part: null, feed: 600, time_s: this.time, tool: 1, calls: [] });
    this.figures.push({ ball: to, deviation: null, angle: null, role: 'positioning' });
  }
}

/** Four sides of a round wall. @param {1 | -1} side the ball is inside (1) or around it (-1) */
function round(tape, part, { u, v, r }, side, shift) {
  for (const [x, y] of [[1, 0], [0, 1], [-1, 0], [0, -1]]) {
    const away = side > 0 ? 0 : r + 12;
    tape.go(0, [u + x * away, v + y * away, SAFE], 200, 20);
    tape.miss([u + x * away, v + y * away, DEPTH], 25);
    const contact = [u + x * r, v + y * r, DEPTH];
    const normal = [-side * x, -side * y, 0];
    tape.touch(part, contact, normal, DEVIATION.fast, 600, 26, 'first touch');
    tape.go(1, tape.ball.map((value, axis) => value + normal[axis] * 2), 20, 30);
    tape.touch(part, contact, normal, DEVIATION.slow + 0.001 * x + shift, 50, 38, 'measuring');
    tape.go(0, [u + x * away, v + y * away, DEPTH], 100, 40);
    tape.go(0, [u + x * away, v + y * away, SAFE], 200, 41);
  }
}

/** @param {{rounds?: number, crash?: boolean, shift?: number, lines?: number, text?: (line: number) => string}} [wish] */
export function sampleRun({ rounds = 1, crash = false, shift = 0, lines = 60, text } = {}) {
  const tape = new Tape(shift);
  const calls = [];
  for (let n = 0; n < rounds; ++n) {
    for (const [program, line, part, wall, side] of [['O9010', 4, 'housing', BORE, 1], ['O9020', 5, 'plate', PIN, -1]]) {
      const from = tape.time;
      round(tape, part, wall, side, shift);
      calls.push({ program, level: 1, file: 'main.nc', line, time_s: [from, tape.time], blocks: [n, n] });
    }
  }
  let collision = null;
  if (crash) {
    tape.go(0, [PIN.u - 30, PIN.v, DEPTH], 200, 44);
    tape.go(0, [PIN.u - PIN.r - BALL / 2, PIN.v, DEPTH], 200, 45);
    tape.ways.at(-1).move = -1;
    tape.moves.pop();
    collision = { what: 'the ball touches plate', at: tape.ball, work: tape.ball, contact: [PIN.u - PIN.r, PIN.v, DEPTH],
      normal: [-1, 0, 0], part: 'plate', file: 'O9010.nc', line: 45, tool: 1, calls: [], move: { g: 0, to: [250, 80, -185] } };
  }
  const code = Array.from({ length: lines }, (_, n) => (text ? text(n + 1) : `N${n + 1} G31 X#24 F#9 (LINE ${n + 1})`));
  const counted = {};
  for (let n = 1; n <= lines; ++n) if (n % 7) counted[n] = n % 11 ? 1 + (n % 5) : 0;
  const document = {
    schema: 'g31.run/1', program: 'main.nc', version: '0.1.0', control: 'fanuc-16i', seed: 0, status: crash ? 'collision' : 'completed',
    exit_code: crash ? 3 : 0, alarm: null, blocks: 120, machine_time_s: tape.time, moves: tape.moves, touches: tape.touches,
    calls: [{ program: 'O0001', level: 0, time_s: [0, tape.time], blocks: [0, 9] }, ...calls],
    counts: [{ file: 'O9010.nc', lines: counted, conditions: { 14: [0, 2] } }, { file: 'main.nc', lines: { 1: 1, 2: 1, 3: 1, 4: rounds, 5: rounds } }],
    collision, history: [],
  };
  const mesh = (name, origin, { positions, triangles }) => ({ name, shape: null, sizes: {}, fixture: false, origin,
    positions: base64(new Float32Array(positions)), triangles: base64(new Uint32Array(triangles)) });
  const figures = {
    parts: [mesh('housing', [BORE.u, BORE.v, -300], bored(38, 20, BORE.r)), mesh('plate', [PIN.u, PIN.v, -312], pinned(30, 8, PIN.r, 14))],
    probe: { ball: BALL, offset: [0, 0, -120], stem: { diameter: 3, length: 30 }, body: { diameter: 20, length: 40 }, holder: null },
    ways: tape.ways, touch: tape.figures.map((each, n) => ({ ...each,
      part_deviation: each.deviation != null && tape.touches[n].part === 'housing' ? MODEL_SIZE : null })),
    frame: { name: 'G54', origin: FRAME }, compare: null, words: {}, language: 'en',
    listing: [{ file: 'main.nc', text: ['O0001', 'G54', 'T1 M6', 'G65 P9010 D40.', 'G65 P9020 D12.', 'M30'].join('\n') },
      { file: 'O9010.nc', text: code.join('\n') }],
  };
  return { document, figures };
}
