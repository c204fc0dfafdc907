// Arrows of a plan view: along which way the ball came to each wall.
import { flat } from './plan_planes.js';

const MOST = 24; // arrows
const ALIKE = 0.02; // of half the view; arrows nearer to each other than that are one
const SHORTEST = 0.1; // of half the view; a shorter arrow beside the ball would be all head

/** @typedef {import('./section').Flat} Flat */

/** The arrow of a touch: behind the ball where its way is long enough, else the way itself, to the ball's centre.
 * @param {import('./types').Contact} contact @param {import('./plan_view').PlanView} view
 * @returns {{from: Flat, to: Flat} | null} null where its way is not known or does not go along the plane */
export function approachOf({ ball, radius, time }, { run, plane, frame: { half } }) {
  const way = run.wayAt(time);
  const end = run.ballAt(time);
  if (!ball || !way || !end) return null;
  const [du, dv] = flat(end.map((value, axis) => value - way.points[axis]), plane);
  const long = Math.hypot(du, dv);
  if (long < 1e-3 * half) return null;
  const away = radius + 0.04 * half;
  const tail = Math.min(long, away + Math.min(0.3 * half, 5 * (radius || half)));
  const head = tail - away > SHORTEST * half ? away : 0;
  const [u, v] = flat(ball, plane);
  const behind = (/** @type {number} */ mm) => /** @type {Flat} */ ([u - (du / long) * mm, v - (dv / long) * mm]);
  return { from: behind(tail), to: behind(head) };
}

/** @param {import('./plan_view').PlanView} view @param {import('./plan').Sheet} page */
export function drawApproaches(view, page) {
  const seen = new Set();
  return view.contacts.map((contact) => {
    const arrow = seen.size > MOST ? null : approachOf(contact, view);
    const key = arrow && [...arrow.from, ...arrow.to].map((mm) => Math.round(mm / (ALIKE * view.frame.half))).join(' ');
    if (!arrow || seen.has(key)) return '';
    seen.add(key);
    return page.arrow(arrow.from, arrow.to, 'var(--skip)', 1.3);
  }).join('');
}
