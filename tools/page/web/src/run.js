// What a run says at any time: where the ball is, which move and which line it is, which touches there are.

import { placeAt, trackOf } from './track.js';
import { UPRIGHT, between, turned } from './turn.js';

/** @typedef {import('./types').Contact} Contact */
/** @typedef {import('./types').TimedMove} TimedMove */
/** @typedef {import('./types').WayFigure} Way */

const AT_ONCE = 1e-6; // s; times of one moment differ by rounding alone
const SAME_PLACE = 0.5; // mm; a second touch of one wall comes closer than that to the first
const SAME_LINE = 0.02; // mm; beside it no axis goes on purpose
const SAME_WAY = 0.999; // of the normals, the cosine between them

/** @param {{g: number}} move @returns {import('./types').Kind} */
const kindOf = (move) => (move.g === 0 ? 'rapid' : move.g === 31 ? 'skip' : 'feed');

/** The last index whose key is at most the value, or -1. @template T
 * @param {T[]} list sorted by key @param {number} value @param {(item: T) => number} key */
function lastUpTo(list, value, key) {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (key(list[middle]) <= value) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class Run {
  /** @param {import('./types').RunDocument} document @param {import('./types').Figures} figures */
  constructor(document, figures) {
    this.document = document;
    this.figures = figures;
    this.frame = figures.frame ?? { name: '', origin: [0, 0, 0] };
    /** @type {Way[]} */
    this.ways = figures.ways ?? [];
    this.track = figures.track ?? trackOf(this.ways);
    this.moves = timedMoves(document);
    /** Whether its moves have times: without, a time line has no place for them. */
    this.hasTimes = this.moves.length === (document.moves ?? []).length;
    this.contacts = contactsOf(document, figures);
    this.hits = this.contacts.filter((contact) => contact.hit);
    this.collision = document.collision ? { ...document.collision, ...figures.collision } : null;
    const ends = [document.machine_time_s ?? 0, this.moves.at(-1)?.until ?? 0, this.ways.at(-1)?.time_s[1] ?? 0];
    this.duration = Math.max(...ends);
  }

  /** The ball centre in the machine frame; null before the first way. @param {number} time */
  ballAt(time) {
    return this.ways.length && this.track.times.length ? placeAt(this.track, time) : null;
  }

  /** How what carries the ball is turned. @param {number} time */
  turnAt(time) {
    const way = this.ways[Math.max(0, lastUpTo(this.ways, time, (each) => each.time_s[0]))];
    if (!way?.turns) return UPRIGHT;
    const [from, until] = way.time_s;
    return between(way.turns[0], way.turns[1], until > from ? Math.min(1, Math.max(0, (time - from) / (until - from))) : 1);
  }

  /** The way that the ball is on, or whose end it has just come to. @param {number} time @returns {Way | null} */
  wayAt(time) {
    return this.ways[lastUpTo(this.ways, time - AT_ONCE, (way) => way.time_s[1]) + 1] ?? null;
  }

  /** All balls of the stylus in true size, the main one first; none before the first way. @param {number} time */
  ballsAt(time) {
    const main = this.ballAt(time);
    const { probe } = this.figures;
    if (!main) return [];
    const turn = this.turnAt(time);
    const further = (probe?.further ?? []).map(({ at, diameter }) => {
      const off = turned(at, turn);
      return { at: main.map((value, axis) => value + off[axis]), radius: diameter / 2 };
    });
    return [{ at: main, radius: (probe?.ball ?? 0) / 2 }, ...further];
  }

  /** The move that is on its way, or that has just ended. @param {number} time */
  moveAt(time) {
    const behind = lastUpTo(this.moves, time - AT_ONCE, (move) => move.until);
    return this.moves[Math.min(behind + 1, this.moves.length - 1)] ?? null;
  }

  /** File and line that the machine is at; a touch knows them better than the moves. @param {number} time
   * @param {Contact | null} chosen */
  placeAt(time, chosen) {
    if (this.collision?.file && time >= this.duration - AT_ONCE) return this.collision;
    if (chosen && Math.abs(chosen.time - time) < AT_ONCE) return chosen.touch;
    return this.moveAt(time);
  }

  /** @param {number} time @returns {import('./types').Kind | 'collision'} */
  kindAt(time) {
    if (this.collision && time >= this.duration - AT_ONCE) return 'collision';
    const way = this.ways[lastUpTo(this.ways, time, (each) => each.time_s[0])];
    return this.moveAt(time)?.kind ?? way?.kind ?? 'rapid';
  }

  /** @param {number} number from 1 @returns {Contact | null} */
  contact(number) {
    return this.contacts[number - 1] ?? null;
  }
}

/** @param {import('./types').RunDocument} document @returns {TimedMove[]} */
function timedMoves(document) {
  let from = 0;
  return (document.moves ?? []).filter((move) => move.time_s != null).map((move) => {
    const until = /** @type {number} */ (move.time_s);
    const timed = { ...move, kind: kindOf(move), from, until };
    from = until;
    return timed;
  });
}

/** @param {import('./types').RunDocument} document @param {import('./types').Figures} figures @returns {Contact[]} */
function contactsOf(document, figures) {
  const contacts = (document.touches ?? []).map((touch, index) => {
    const figure = figures.touch?.[index];
    return {
      number: index + 1,
      touch,
      time: touch.time_s,
      hit: touch.triggered && touch.contact != null,
      place: figure?.contact ?? touch.contact,
      normal: figure?.normal ?? touch.normal,
      ball: figure?.ball ?? null,
      radius: figure?.radius ?? (figures.probe?.ball ?? 0) / 2,
      deviation: figure?.deviation ?? null,
      partDeviation: figure?.part_deviation ?? null,
      limits: figure?.limits ?? null,
      angle: figure?.angle ?? null,
      role: figure?.role ?? '',
      counts: touch.triggered,
    };
  });
  const hits = contacts.filter((contact) => contact.hit);
  hits.forEach((contact, index) => {
    contact.counts = !(index + 1 < hits.length && repeats(contact, hits[index + 1]));
  });
  return contacts;
}

/** Whether the second touch repeats the first: slower, at the same place along one line.
 * @param {Contact} first @param {Contact} second */
function repeats(first, second) {
  const [before, after] = [first.touch, second.touch];
  if (before.part !== after.part || !(after.feed < before.feed) || !(first.time < second.time)) return false;
  if (!first.normal || !second.normal || !first.place || !second.place) return false;
  const { normal, place } = second;
  if (!(first.normal.reduce((sum, value, axis) => sum + value * normal[axis], 0) > SAME_WAY)) return false;
  if (!(Math.hypot(...first.place.map((value, axis) => value - place[axis])) < SAME_PLACE)) return false;
  const off = [0, 1, 2].map((axis) => after.latched[axis] - before.latched[axis]);
  const way = [0, 1, 2].map((axis) => (after.commanded ?? after.latched)[axis] - after.latched[axis]);
  const long = Math.hypot(...way);
  const along = long > 0 ? way.map((value) => value / long) : normal;
  const gone = off.reduce((sum, value, axis) => sum + value * along[axis], 0);
  const beside = Math.hypot(...off.map((value, axis) => value - gone * along[axis]));
  return beside < SAME_LINE;
}
