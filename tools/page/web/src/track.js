// Where the ball is at every time: cubics between knots that have a place and a speed.

/** @typedef {import('./types').TrackFigure} Track */
/** @typedef {import('./types').WayFigure} Way */

/** A track along ways of which no more is known than when they begin and end. @param {Way[]} ways @returns {Track} */
export function trackOf(ways) {
  /** @type {Track} */
  const track = { times: [], points: [], speeds: [] };
  for (const { time_s: [from, until], points } of ways) {
    const steps = points.length / 3 - 1;
    for (let n = 0; n < steps; ++n) {
      const seconds = (until - from) / steps;
      const [a, b] = [points.slice(3 * n, 3 * n + 3), points.slice(3 * n + 3, 3 * n + 6)];
      const speed = a.map((value, axis) => (seconds > 0 ? (b[axis] - value) / seconds : 0));
      track.times.push(from + n * seconds, from + (n + 1) * seconds);
      track.points.push(...a, ...b);
      track.speeds.push(...speed, ...speed);
    }
    // Until the next way it stands.
    track.times.push(until);
    track.points.push(...points.slice(-3));
    track.speeds.push(0, 0, 0);
  }
  return track;
}

/** One coordinate between a knot and the next. @param {Track} track @param {number} knot @param {number} axis @param {number} share of the time */
export function between({ times, points, speeds }, knot, axis, share) {
  const seconds = times[knot + 1] - times[knot];
  const rest = 1 - share;
  const at = 3 * knot + axis;
  return rest * rest * (1 + 2 * share) * points[at] + share * share * (1 + 2 * rest) * points[at + 3]
    + seconds * share * rest * (rest * speeds[at] - share * speeds[at + 3]);
}

/** Where it is; before the first knot and behind the last one it stands. @param {Track} track with knots @param {number} time */
export function placeAt(track, time) {
  const { times, points } = track;
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle + 1;
    else high = middle;
  }
  const last = Math.max(0, low - 1);
  if (!low || low === times.length) return points.slice(3 * last, 3 * last + 3);
  const share = (time - times[last]) / (times[low] - times[last]);
  return [0, 1, 2].map((axis) => between(track, last, axis, share));
}

/** Whether a coordinate goes evenly from a knot to the next. @param {Track} track @param {number} knot @param {number} axis */
export function isEven({ times, points, speeds }, knot, axis) {
  const at = 3 * knot + axis;
  const seconds = times[knot + 1] - times[knot];
  const way = points[at + 3] - points[at];
  const off = (/** @type {number} */ speed) => Math.abs(speed * seconds - way);
  return off(speeds[at]) < 1e-3 && off(speeds[at + 3]) < 1e-3;
}
