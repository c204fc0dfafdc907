// What the time line draws, thinned to what its pixels can show: a run of a day costs what one of a minute does.
import { between, isEven } from './track.js';

const WORKING = 1; // mm; a curve that spans less is drawn as if it spanned this much either way
const LEVELS = 6; // of calls
const BEND = 3; // px; a curve that bends is drawn in steps of that

/** @typedef {(time: number) => number} X */

/** Bands of motion by kind, as pairs of x; those that touch within a pixel are one.
 * @param {import('./run').Run} run @param {X} x */
export function bandsOf(run, x) {
  /** @type {Record<import('./types').Kind, [number, number][]>} */
  const bands = { rapid: [], feed: [], skip: [] };
  /** @type {{kind: import('./types').Kind, from: number, until: number}[]} */
  const spans = run.ways.length
    ? run.ways.map(({ kind, time_s: [from, until] }) => ({ kind, from, until }))
    : run.moves;
  for (const { kind, from, until } of spans) {
    if (!(until > from)) continue;
    const a = x(from);
    const b = Math.max(a + 0.6, x(until));
    const last = bands[kind].at(-1);
    if (last && a - last[1] < 0.5 && b - last[0] < 4) last[1] = Math.max(last[1], b);
    else if (last && a < last[1]) last[1] = Math.max(last[1], b);
    else bands[kind].push([a, b]);
  }
  return bands;
}

/** Calls as rows of a flame; those narrower than half a pixel are left out behind another of their level.
 * @param {import('./run').Run} run @param {X} x */
export function spansOf(run, x) {
  const ends = new Array(LEVELS).fill(-9);
  const shown = [];
  for (const span of run.document.calls ?? []) {
    if (span.level >= LEVELS) continue;
    const from = x(span.time_s[0]);
    const until = x(span.time_s[1]);
    if (until - from < 0.5 && until - ends[span.level] < 1) continue;
    ends[span.level] = until;
    shown.push({ span, level: span.level, from, width: Math.max(1, until - from - 1) });
  }
  return shown;
}

/** Where numbers of touches have room: the chosen one always, then those that count, then the rest.
 * @param {import('./choice').Choice} choice @param {X} x @param {number} gap px @param {number} right px */
export function marksOf(choice, x, gap, right) {
  const { hits } = choice.run;
  if (hits.length * gap <= right - x(0)) return spread(hits, x, gap, right);
  const chosen = hits.filter((contact) => contact.number === choice.touch);
  /** @type {{contact: import('./types').Contact, x: number}[]} */
  const placed = [];
  const slots = new Set();
  for (const contact of [...chosen, ...hits.filter((each) => each.counts), ...hits]) {
    const at = Math.min(x(contact.time), right);
    const slot = Math.floor(at / gap);
    if ([slot - 1, slot, slot + 1].some((near) => slots.has(near))) continue;
    slots.add(slot);
    placed.push({ contact, x: at });
  }
  return placed;
}

/** All numbers, moved apart as far as they must be.
 * @param {import('./types').Contact[]} hits @param {X} x @param {number} gap @param {number} right */
function spread(hits, x, gap, right) {
  let end = -Infinity;
  const placed = hits.map((contact) => {
    end = Math.max(x(contact.time), end + gap);
    return { contact, x: end };
  });
  let start = right;
  for (let n = placed.length - 1; n >= 0; --n) {
    placed[n].x = Math.min(placed[n].x, start);
    start = placed[n].x - gap;
  }
  return placed;
}

/** What the curves of X, Y and Z span, mm: where the run works, not how far off its rapids begin.
 * @param {import('./run').Run} run @returns {[number, number][]} */
export function rangesOf(run) {
  const works = run.ways.filter((way) => way.kind !== 'rapid');
  const ways = works.length ? works : run.ways;
  return [0, 1, 2].map((axis) => {
    let low = Infinity;
    let high = -Infinity;
    for (const { points } of ways) {
      for (let at = axis; at < points.length; at += 3) {
        low = Math.min(low, points[at]);
        high = Math.max(high, points[at]);
      }
    }
    if (!(high >= low)) [low, high] = [0, 0];
    low -= run.frame.origin[axis];
    high -= run.frame.origin[axis];
    return high - low < WORKING ? [low - WORKING, high + WORKING] : [low, high + 0.1 * (high - low)];
  });
}

/** Curves of X, Y and Z in the frame that is shown: per pixel the first, lowest, highest and last value.
 * @param {import('./run').Run} run @param {X} x @returns {[number, number][][]} */
export function curvesOf(run, x) {
  return [0, 1, 2].map((axis) => {
    const origin = run.frame.origin[axis];
    /** @type {[number, number][]} */
    const curve = [];
    let column = { x: -Infinity, low: 0, high: 0, last: 0 };
    const close = () => {
      if (column.low !== column.high) curve.push([column.x, column.low], [column.x, column.high]);
      curve.push([column.x, column.last]);
    };
    const put = (/** @type {number} */ px, /** @type {number} */ value) => {
      if (px - column.x < 0.5) {
        column.low = Math.min(column.low, value);
        column.high = Math.max(column.high, value);
        column.last = value;
        return;
      }
      if (column.x > -Infinity) close();
      column = { x: px, low: value, high: value, last: value };
    };
    const { times, points } = run.track;
    for (let knot = 0; knot < times.length; ++knot) {
      put(x(times[knot]), points[3 * knot + axis] - origin);
      if (knot + 1 === times.length || isEven(run.track, knot, axis)) continue;
      const steps = Math.ceil((x(times[knot + 1]) - x(times[knot])) / BEND);
      for (let n = 1; n < steps; ++n) {
        const share = n / steps;
        put(x(times[knot] + share * (times[knot + 1] - times[knot])), between(run.track, knot, axis, share) - origin);
      }
    }
    if (column.x > -Infinity) close();
    return curve;
  });
}
