// What figures show, against closed forms: sections, circles, the run at a time, captions, marks.
import assert from 'node:assert/strict';
import test, { after, before } from 'node:test';
import { launch, open, pageOf, reportBy } from './browser.mjs';
import { BORE, PIN, sampleRun } from './sample_run.mjs';
import { decimalsWithin } from '../../tools/page/web/src/markup.js';
import { approachOf, drawApproaches } from '../../tools/page/web/src/plan_approaches.js';
import { planesOf } from '../../tools/page/web/src/plan_planes.js';
import { PlanView } from '../../tools/page/web/src/plan_view.js';
import { Run } from '../../tools/page/web/src/run.js';
import { circleOf, cutsOf, outlinesOf, roundOf } from '../../tools/page/web/src/section.js';
import { curvesOf } from '../../tools/page/web/src/timeline_layers.js';
import { onScale } from '../../tools/page/web/src/timeline_curves.js';
import { SolidEdges, cylinder } from '../../tools/page/web/src/solid_edges.js';
import { between, fromZ, turned, turnedBack } from '../../tools/page/web/src/turn.js';

let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const near = (value, wanted, by) => assert.ok(Math.abs(value - wanted) <= by, `${value} is not ${wanted} +- ${by}`);

test('a circle through points of a circle is that circle', () => {
  for (const angles of [[0, 1, 2], [0, 0.3, 3, 4], [1, 2, 3, 4, 5, 6]]) {
    const { u, v, r } = circleOf(angles.map((a) => [150 + 20 * Math.cos(a), -80 + 20 * Math.sin(a)]));
    for (const [value, wanted] of [[u, 150], [v, -80], [r, 20]]) near(value, wanted, 1e-9);
  }
  assert.equal(circleOf([[0, 0], [1, 1], [2, 2]]), null);
});

test('the section of a cylinder is its circle, at any height and from any origin', () => {
  const part = { ...cylinder(12, -3, 9), origin: [1000, -500, 30] };
  for (const height of [27.5, 30, 38.9]) {
    const cuts = cutsOf(part, [0, 0, 1], height);
    const ends = [];
    for (let n = 0; n < cuts.length; n += 3) {
      ends.push([cuts[n], cuts[n + 1]]);
      near(cuts[n + 2], height, 1e-9);
    }
    const outlines = outlinesOf(ends);
    assert.equal(outlines.length, 1);
    const circle = roundOf(outlines[0]);
    near(circle.u, 1000, 1e-3); // its corners are not evenly spread
    near(circle.v, -500, 1e-3);
    near(circle.r, 6, 0.02); // corners lie on the circle, the cuts of the sides' diagonals within
  }
  assert.deepEqual(cutsOf(part, [0, 0, 1], 40), []);
});

test('a square is not round', () => {
  const side = (a, b) => Array.from({ length: 10 }, (_, n) => [a[0] + (n / 10) * (b[0] - a[0]), a[1] + (n / 10) * (b[1] - a[1])]);
  assert.equal(roundOf([...side([0, 0], [1, 0]), ...side([1, 0], [1, 1]), ...side([1, 1], [0, 1]), ...side([0, 1], [0, 0])]), null);
});

test('a cylinder has two sharp rims and two sides that turn away', () => {
  const edges = new SolidEdges(cylinder(10, 0, 5));
  assert.equal(edges.sharp.length / 6, 2 * 48);
  assert.equal(edges.silhouette([1, 0.01, 0]).length / 6 >= 2, true);
  assert.equal(edges.silhouette([0, 0, 1]).length, 0);
});

test('the ball is where its way has it', () => {
  const { document, figures } = sampleRun();
  const run = new Run(document, figures);
  for (const [index, way] of figures.ways.entries()) {
    const [from, until] = way.time_s;
    const middle = [0, 1, 2].map((axis) => (way.points[axis] + way.points[6 + axis]) / 2);
    run.ballAt((from + until) / 2).forEach((value, axis) => near(value, middle[axis], 1e-9));
    assert.equal(run.kindAt((from + until) / 2), way.kind);
    assert.equal(run.moveAt((from + until) / 2).line, document.moves[index].line);
  }
  run.ballAt(1e9).forEach((value, axis) => near(value, figures.ways.at(-1).points[6 + axis], 1e-9));
});

/** A rapid of 188 mm up Z that accelerates and brakes with 2000 mm/s2 to 500 mm/s, from 0.3 s on. */
const RAMP = { a: 2000, v: 500, from: 0.3, long: 188 };

function rampAt(time) {
  const { a, v, from, long } = RAMP;
  const up = v / a;
  const all = up + long / v;
  const t = Math.min(Math.max(0, time - from), all);
  if (t < up) return a / 2 * t * t;
  return t < all - up ? v * (t - up / 2) : long - a / 2 * (all - t) ** 2;
}

function rampRun() {
  const { a, v, from, long } = RAMP;
  const up = v / a;
  const all = up + long / v;
  const ramp = v * up / 2;
  const knots = [[0, 0, 0], [from, 0, 0], [from + up, ramp, v], [from + all - up, long - ramp, v], [from + all, long, 0]];
  const track = { times: knots.map(([time]) => time), points: knots.flatMap(([, z]) => [45, 0, z]), speeds: knots.flatMap(([, , speed]) => [0, 0, speed]) };
  const ways = [{ move: 0, kind: 'rapid', time_s: [from, from + all], points: [45, 0, 0, 45, 0, long] }];
  return { document: { moves: [{ g: 0, to: [45, 0, long], time_s: from + all }], machine_time_s: 1 }, figures: { ways, track } };
}

test('the ball and its curves are where acceleration has them', () => {
  const { document, figures } = rampRun();
  const run = new Run(document, figures);
  for (let time = 0; time <= 1; time += 0.005) {
    run.ballAt(time).forEach((value, axis) => near(value, [45, 0, rampAt(time)][axis], 1e-9));
  }
  const [, , z] = curvesOf(run, (time) => 1000 * time);
  assert.ok(z.length > 100, 'a curve that bends has many points');
  for (const [px, value] of z) near(value, rampAt(px / 1000), 0.6 * RAMP.v / 1000); // within the pixel
});

/** Skip moves along X to the wall at X = 33 as touches, from their places beside it and their feeds. */
const touchesAt = (places) => ({
  touches: places.map(([y, feed], n) => ({ triggered: true, part: 'block', feed, time_s: n, contact: [30, y, 0], normal: [1, 0, 0],
    commanded: [25, y, 0], latched: [33, y, 0], work: [33, y, 0] })),
});

test('a touch counts unless a slower one goes on along its line', () => {
  const counts = (places) => new Run(touchesAt(places), {}).hits.map((contact) => contact.counts);
  assert.deepEqual(counts([[0, 600], [0, 50]]), [false, true]);
  assert.deepEqual(counts([[0, 50], [0, 50], [0, 600]]), [true, true, true], 'as fast again, or faster');
  assert.deepEqual(counts([[0, 100], [0.4, 100], [0.8, 100]]), [true, true, true], 'a row of touches');
  assert.deepEqual(counts([[0, 600], [0.4, 50]]), [true, true], 'slower, beside it');
});

const QUARTER = [0, 0, Math.SQRT1_2, Math.SQRT1_2]; // about Z

test('a turn is that of its quaternion, there and back, and half of it on the way', () => {
  const same = (got, wanted) => got.forEach((value, n) => near(value, wanted[n], 1e-12));
  same(turned([1, 2, 3], QUARTER), [-2, 1, 3]);
  same(turned([1, 2, 3], [Math.SQRT1_2, 0, 0, Math.SQRT1_2]), [1, -3, 2]);
  same(turnedBack([-2, 1, 3], QUARTER), [1, 2, 3]);
  same(turned([1, 0, 0], between([0, 0, 0, 1], QUARTER, 0.5)), [Math.SQRT1_2, Math.SQRT1_2, 0]);
  same(turned([1, 0, 0], between([0, 0, 0, 1], QUARTER.map((value) => -value), 0.5)), [Math.SQRT1_2, Math.SQRT1_2, 0]);
  for (const along of [[1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1], [0.48, -0.6, -0.64]]) same(turned([0, 0, 1], fromZ(along)), along);
});

/** The sample with a second ball 9 mm beside the main one that made the third touch, the spindle turned by a quarter. */
function starRun() {
  const run = sampleRun();
  run.figures.probe.further = [{ at: [9, 0, 0], diameter: 3 }];
  run.figures.probe.arms = [{ from: [0, 0, 0], to: [9, 0, 0], diameter: 1 }];
  for (const way of run.figures.ways) way.turns = [QUARTER, QUARTER];
  const { contact, normal } = run.document.touches[2];
  Object.assign(run.figures.touch[2], { ball: contact.map((value, axis) => value + 1.5 * normal[axis]), radius: 1.5 });
  return run;
}

test('balls of a star stylus stand where the spindle has turned them', () => {
  const { document, figures } = starRun();
  const [main, second] = new Run(document, figures).ballsAt(1);
  near(main.radius, 3, 0);
  near(second.radius, 1.5, 0);
  [0, 9, 0].forEach((value, axis) => near(second.at[axis] - main.at[axis], value, 1e-9));
});

test('the ball that touched is drawn, in its size and place', async () => {
  const { page, notes, close } = await open(browser, pageOf('star', starRun()));
  await page.click('tr[data-touch="3"] td:nth-child(3)');
  const circles = await page.evaluate(() => [...document.querySelectorAll('#plan svg circle')].map((circle) => ({
    moves: circle.classList.contains('pball'), x: Number(circle.getAttribute('cx')), y: Number(circle.getAttribute('cy')),
    r: Number(circle.getAttribute('r')), fill: circle.getAttribute('fill') })));
  const [main, second] = circles.filter(({ moves }) => moves);
  const scale = main.r / 3;
  near(second.r, 1.5 * scale, 0.06);
  near(main.y - second.y, 9 * scale, 0.3); // up is +Y
  near(second.x, main.x, 0.3);
  // The slow touch of the same wall by the main ball has that ball's place; this one is another circle.
  const latched = circles.filter(({ fill }) => fill === 'var(--paper)');
  assert.equal(latched.filter(({ r }) => Math.abs(r - 1.5 * scale) < 0.1).length, 1);
  assert.ok(latched.some(({ r }) => Math.abs(r - main.r) < 0.1));
  assert.deepEqual(notes, []);
  await close();
});

test('slow touches count, the fast ones that they repeat do not', () => {
  const { document, figures } = sampleRun({ rounds: 2 });
  const run = new Run(document, figures);
  for (const contact of run.hits) assert.equal(contact.counts, contact.role === 'measuring', `touch ${contact.number}`);
});

test('the plan says what was put in: centre 1 um off in X, diameter by part and measurement', async () => {
  const { page, close } = await open(browser, pageOf('plan', sampleRun()));
  await page.click('tr[data-touch="3"] td:nth-child(3)');
  const caption = await page.textContent('#plancap');
  assert.match(caption, /off the true one by X \+1\.0 Y 0\.0 µm, diameter \+29\.4 µm/); // 2 (10.5 + 4.2)
  assert.match(await page.textContent('#plan svg'), /\+15\.7 µm/); // 10.5 + 4.2 + 1.0 at +X
  const ball = await page.evaluate(() => document.querySelector('#pball').getBoundingClientRect().width);
  const bore = await page.evaluate(() => {
    const d = document.querySelector('#plan path').getAttribute('d').split('M').slice(1).map((loop) => loop.match(/[-\d.]+ [-\d.]+/g).map((p) => p.split(' ').map(Number)));
    return Math.min(...d.map((loop) => Math.max(...loop.map((p) => p[0])) - Math.min(...loop.map((p) => p[0]))));
  });
  near((ball - 1.8) / bore, 6 / (2 * BORE.r), 0.01); // true size, but for the stroke
  await close();
});

/** The sample as a table turned by a quarter has it in the document; pictures have the parts as they stand. */
function turnedRun() {
  const run = sampleRun();
  run.document.touches.forEach((touch, n) => {
    if (!touch.contact) return;
    const { contact, normal } = touch;
    Object.assign(run.figures.touch[n], { contact, normal });
    Object.assign(touch, { contact: turned(contact, QUARTER), normal: turned(normal, QUARTER) });
  });
  return run;
}

test('touches of a turned part are drawn where it stands', async () => {
  const { document, figures } = turnedRun();
  const upright = sampleRun();
  const run = new Run(document, figures);
  new Run(upright.document, upright.figures).contacts.forEach(({ place, normal, counts }, n) => {
    assert.deepEqual([run.contacts[n].place, run.contacts[n].normal, run.contacts[n].counts], [place, normal, counts]);
  });
  const { page, close } = await open(browser, pageOf('turned', turnedRun()));
  await page.click('tr[data-touch="3"] td:nth-child(3)');
  assert.match(await page.textContent('#plancap'), /off the true one by X \+1\.0 Y 0\.0 µm, diameter \+29\.4 µm/);
  assert.ok(await page.locator('.scene-labels .badge').count() >= 8);
  await close();
});

/** The sample with its housing, and what touched it, tilted about the housing's origin. */
function tiltedRun(turn) {
  const run = sampleRun();
  const [housing] = run.figures.parts;
  const { origin } = housing;
  const about = (point) => turned(point.map((value, axis) => value - origin[axis]), turn).map((value, axis) => value + origin[axis]);
  const bytes = Buffer.from(housing.positions, 'base64');
  const flat = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
  const positions = new Float32Array(flat.length);
  for (let at = 0; at < flat.length; at += 3) positions.set(turned([...flat.subarray(at, at + 3)], turn), at);
  Object.assign(housing, { turn, positions: Buffer.from(positions.buffer).toString('base64') });
  run.document.touches.forEach((touch, n) => {
    const figure = run.figures.touch[n];
    if (touch.part !== 'housing') return;
    Object.assign(touch, { contact: about(touch.contact), normal: turned(touch.normal, turn) });
    figure.ball = about(figure.ball);
  });
  return run;
}

test('a tilted part is seen along its own axes', async () => {
  const turn = [Math.sin(0.3), 0, 0, Math.cos(0.3)];
  const { page, close } = await open(browser, pageOf('tilted', tiltedRun(turn)));
  await page.click('tr[data-touch="3"] td:nth-child(3)');
  assert.match(await page.textContent('#planhead'), /housing, part frame, section at Z −5\.0 mm/);
  assert.match(await page.textContent('#plancap'), /off the true one by X \+1\.0 Y 0\.0 µm, diameter \+29\.4 µm/);
  await page.click('tr[data-touch="24"] td:nth-child(3)'); // a part that is not tilted
  assert.match(await page.textContent('#planhead'), /plate, G54, section at Z/);
  await close();
});

test('a plan is as large as what was touched with, and not as what was touched is long', () => {
  const { document, figures } = sampleRun();
  for (const figure of figures.touch) figure.radius = 20;
  const { name, origin, positions, triangles } = figures.parts[1];
  const bytes = (text) => Uint8Array.from(Buffer.from(text, 'base64')).buffer;
  const part = { name, origin, fixture: false, turn: [0, 0, 0, 1], positions: new Float32Array(bytes(positions)), triangles: new Uint32Array(bytes(triangles)) };
  const [plane] = planesOf(part);
  near(new PlanView(new Run(document, figures), part, plane).frame.half, 50, 1e-9);
  // A beam along X that tools meet from above.
  const beam = { ...part, fixture: true, positions: part.positions.map((value, n) => (n % 3 === 0 ? 20 * value : value)) };
  for (const touch of document.touches) touch.normal = touch.normal && [0, 0, 1];
  const view = new PlanView(new Run(document, figures), beam, plane);
  near(view.bounds.high[0] - view.bounds.low[0], 1200, 1e-9);
  near(view.frame.half, 50, 1e-9);
  near(view.frame.u, PIN.u, 1e-9);
  near(new PlanView(new Run(document, figures), { ...beam, fixture: false }, plane).frame.half, 660, 1e-9);
});

/** Part and plane of the sample's housing. */
function housingView(run) {
  const { name, origin, positions, triangles } = run.figures.parts[0];
  const bytes = (text) => Uint8Array.from(Buffer.from(text, 'base64')).buffer;
  const part = { name, origin, fixture: false, turn: [0, 0, 0, 1], positions: new Float32Array(bytes(positions)), triangles: new Uint32Array(bytes(triangles)) };
  return new PlanView(run, part, planesOf(part)[0]);
}

test('the arrow of a touch lies along its move, and within it', () => {
  const { document, figures } = sampleRun();
  const run = new Run(document, figures);
  const view = housingView(run);
  assert.equal(view.contacts.length, 8);
  for (const contact of view.contacts) {
    const { from, to } = approachOf(contact, view);
    const way = run.wayAt(contact.time);
    assert.equal(way.kind, 'skip');
    const [start, end] = [way.points.slice(0, 2), way.points.slice(-3, -1)];
    const move = [end[0] - start[0], end[1] - start[1]];
    const arrow = [to[0] - from[0], to[1] - from[1]];
    const long = Math.hypot(...move);
    near((arrow[0] * move[0] + arrow[1] * move[1]) / long, Math.hypot(...arrow), 1e-9); // the same direction
    assert.ok(Math.hypot(...arrow) > 0.1 && Math.hypot(...arrow) <= long + 1e-9, `${Math.hypot(...arrow)} of ${long} mm`);
    // A way shorter than the ball is there in whole, to the ball's centre; of a long one what lies behind the ball.
    near(Math.hypot(to[0] - end[0], to[1] - end[1]), long < 3 ? 0 : contact.radius + 0.04 * view.frame.half, 1e-9);
  }
});

test('a curve beyond its scale is not drawn as if it lay at the edge', () => {
  const { within, beyond } = onScale([[0, 0], [10, 0], [20, 300], [30, 300.5], [40, 305]], [299, 301]);
  assert.deepEqual(within.map((piece) => piece.map(([px, mm]) => [Number(px.toFixed(2)), Number(mm.toFixed(2))])),
    [[[19.96, 298.9], [20, 300], [30, 300.5], [31.38, 301.12]]]);
  assert.deepEqual(beyond.map(({ isOver, most, from, until }) => [isOver, most, from.toFixed(2), until.toFixed(2)]),
    [[false, 0, '0.00', '19.96'], [true, 305, '31.38', '40.00']]);
  const all = onScale([[0, 299], [10, 301]], [299, 301]);
  assert.deepEqual([all.within.length, all.beyond.length], [1, 0]);
});

test('the time line tells how far a curve goes beyond its scale', async () => {
  const run = sampleRun();
  for (const way of run.figures.ways) if (way.time_s[0] === 0) way.points = way.points.map((mm, n) => (n % 3 === 0 ? mm - 900 : mm));
  const { page, close } = await open(browser, pageOf('beyond', run));
  assert.match(await page.locator('#chart .beyond').first().getAttribute('d'), /^M/);
  await close();
});

test('each wall of a small part has its arrow', () => {
  const { document, figures } = sampleRun();
  const view = housingView(new Run(document, figures));
  const tiny = (value) => value / 1000;
  const drawn = (run) => {
    const arrows = [];
    drawApproaches(run, { arrow: (from, to) => { arrows.push([from, to]); return ''; } });
    return arrows.length;
  };
  const wanted = drawn(view);
  assert.ok(wanted >= 4, `${wanted} arrows`);
  for (const way of figures.ways) way.points = way.points.map(tiny);
  for (const figure of figures.touch) Object.assign(figure, { ball: figure.ball.map(tiny), radius: tiny(3) });
  const small = housingView(new Run(document, figures));
  assert.equal(drawn(Object.assign(small, { frame: { ...view.frame, half: tiny(view.frame.half) } })), wanted);
});

/** Boxes of the numbers of touches in the time line, its words about a collision, and its own edges. */
const timelineBoxes = (page) => page.evaluate(() => {
  const box = (element) => { const { left, right, top, bottom } = element.getBoundingClientRect(); return { left, right, top, bottom }; };
  const svg = document.querySelector('#chart svg');
  return { all: box(svg), marks: [...svg.querySelectorAll('[data-t] rect')].map(box),
    words: [...svg.querySelectorAll('text[fill="var(--bad)"]')].map(box) };
});
const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

test('what is said of a collision and the numbers of touches leave each other room', async () => {
  const { page, close } = await open(browser, pageOf('crashwords', sampleRun({ crash: true })));
  for (const width of [1400, 420]) {
    await page.setViewportSize({ width, height: 1200 });
    await page.waitForTimeout(200);
    const { all, marks, words } = await timelineBoxes(page);
    assert.equal(words.length, 1);
    assert.ok(words[0].top >= all.top && words[0].left >= all.left && words[0].right <= all.right, JSON.stringify({ words, all }));
    assert.deepEqual(marks.filter((box) => meet(box, words[0])), []);
  }
  const covered = await page.evaluate(() => {
    const cross = document.querySelector('#plan path[stroke="var(--bad)"][stroke-width="3"]').getBoundingClientRect();
    return [...document.querySelectorAll('#plan [data-t] rect')].map((rect) => rect.getBoundingClientRect())
      .filter((rect) => rect.left < cross.right && cross.left < rect.right && rect.top < cross.bottom && cross.top < rect.bottom).length;
  });
  assert.equal(covered, 0);
  await close();
});

test('long numbers of touches stay in the time line, apart from each other', async () => {
  const run = sampleRun({ rounds: 40 });
  const { page, close } = await open(browser, pageOf('longnumbers', run));
  const { all, marks } = await timelineBoxes(page);
  assert.ok(marks.length > 10);
  for (const box of marks) assert.ok(box.left >= all.left && box.right <= all.right, JSON.stringify({ box, all }));
  const sorted = marks.sort((a, b) => a.left - b.left);
  sorted.slice(1).forEach((box, n) => assert.ok(box.left > sorted[n].right - 0.5, JSON.stringify([sorted[n], box])));
  await close();
});

test('a value is told with as many decimals as it needs', () => {
  assert.deepEqual([decimalsWithin(1.2, 0.012), decimalsWithin(-0.05, 0.0005), decimalsWithin(300, 1), decimalsWithin(106.7, 0.5)], [1, 2, 0, 0]);
});

test('a collision with a turned part is where it stands', () => {
  const { document, figures } = sampleRun({ crash: true });
  const { contact, normal } = document.collision;
  document.collision.contact = turned(contact, QUARTER);
  assert.deepEqual(new Run(document, { ...figures, collision: { contact, normal } }).collision.contact, contact);
  assert.deepEqual(new Run(document, { ...figures, collision: null }).collision.contact, document.collision.contact);
});

test('another plane can be chosen and shows a section along the bore', async () => {
  const { page, close } = await open(browser, pageOf('planes', sampleRun()));
  await page.click('#planhead button[data-part="0"]');
  await page.click('#planhead button[data-plane="1"]');
  assert.match(await page.textContent('#planhead .sub'), /section at Y/);
  assert.equal(await page.getAttribute('#planhead button[data-plane="1"]', 'aria-pressed'), 'true');
  await close();
});

test('a collision is shown in plan, scene and time line', async () => {
  const { page, close } = await open(browser, pageOf('crash', sampleRun({ crash: true })));
  assert.match(await page.textContent('#plan'), /the ball touches plate/);
  assert.match(await page.textContent('#chart'), /collision, \d+\.\d+ s/);
  assert.equal(await page.locator('.scene-labels path[stroke="var(--bad)"]').count(), 1);
  assert.match(await page.textContent('#now'), /collision.*O9010\.nc:45/);
  await close();
});

/** The sample beside another run, of which only the document and what comes of it is there. */
function comparedRun(shift = 0) {
  const run = sampleRun();
  const { document, figures: { ways, touch } } = sampleRun({ shift });
  run.figures.compare = { document, figures: { ways, touch } };
  return run;
}

/** Curves of the time line: those of the other run and those of the run. */
const curvesIn = (page) => page.evaluate(() => ['.ghost[fill="none"]', 'path[stroke="var(--ink)"][stroke-linejoin="round"]'].map((curves) =>
  [...document.querySelectorAll(`#chart ${curves}`)].map((curve) => curve.getAttribute('d'))));

test('a table too long to be written out tells contacts in the frame of the part, too', async () => {
  const { page, close } = await open(browser, pageOf('long', sampleRun({ rounds: 90 })));
  const cells = await page.locator('tr.sel td').allTextContents();
  assert.deepEqual(cells.slice(10, 14), ['plate', '0.0000', '−6.0000', '7.0000']);
  await close();
});

test('the same run beside itself lies on its own curves', async () => {
  const { page, close } = await open(browser, pageOf('beside', comparedRun()));
  const [ghosts, own] = await curvesIn(page);
  assert.equal(own.length, 3);
  assert.deepEqual(ghosts, own);
  await close();
});

test('another run without times has touches in the time line, and no more', async () => {
  const run = comparedRun();
  for (const move of run.figures.compare.document.moves) delete move.time_s;
  const { page, close } = await open(browser, pageOf('untimed', run));
  assert.deepEqual((await curvesIn(page))[0], []);
  assert.ok(await page.locator('#chart .ghost').count() > 0);
  await close();
});

test('the other run is a dashed ghost in plan and time line', async () => {
  const run = comparedRun(0.004);
  const { page, close } = await open(browser, pageOf('compared', run));
  for (const place of ['#plan .ghost', '#chart .ghost']) {
    assert.ok(await page.locator(place).count() > 0, place);
    assert.match(await page.locator(place).first().getAttribute('stroke-dasharray'), /\d/);
  }
  await close();
});

// Two steps of a shaft are touched at one place as seen from above, its spindle turned by half a turn.
test('a plan of a part that an axis turns is in its coordinates, and none of its values lies on a ball', async (t) => {
  const SHAFT = 'parts/library/turned_shaft';
  const file = reportBy('shaft', ['run', `${SHAFT}/measure_shaft.mpf`, '-s', `${SHAFT}/lathe.toml`]);
  if (file === null) return t.skip('this g31 writes no pages');
  const { page, close } = await open(browser, file);
  assert.match(await page.textContent('#planhead'), /shaft, coordinates of the part, section/);
  for (let n = 0; n < 4; ++n) {
    await page.keyboard.press(']');
    const [values, balls] = await page.evaluate(() => ['text.halo[font-size="12"]', 'circle[stroke="var(--ink3)"]'].map((css) =>
      [...document.querySelectorAll(`#plan ${css}`)].map((one) => one.getBoundingClientRect().toJSON())));
    assert.ok(values.length > 0 && balls.length > 0);
    for (const value of values) {
      for (const ball of balls) {
        assert.ok(value.right < ball.left + 1 || value.left > ball.right - 1 || value.bottom < ball.top || value.top > ball.bottom, `touch ${n}`);
      }
    }
  }
  await close();
});
