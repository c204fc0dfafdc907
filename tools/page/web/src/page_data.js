// Reads what the command has put into the page.
import { gunzipSync, strFromU8 } from 'fflate';
import { UPRIGHT } from './turn.js';

/** @param {string} text base64 */
export function bytesOf(text) {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let at = 0; at < raw.length; ++at) bytes[at] = raw.charCodeAt(at);
  return bytes;
}

/**
 * The JSON of a script element: as it stands, or packed where it is long.
 * @param {string} id
 * @returns {any} null where the page has no such element
 */
export function jsonOf(id) {
  const element = document.getElementById(id);
  if (!element) return null;
  const text = element.textContent ?? '';
  if (element.dataset.encoding !== 'gzip') return JSON.parse(text);
  return JSON.parse(strFromU8(gunzipSync(bytesOf(text.trim()))));
}

/**
 * Meshes of the parts.
 * @param {import('./types').Figures} figures
 * @returns {import('./types').Part[]}
 */
export function partsOf(figures) {
  return (figures.parts ?? []).map((part) => {
    const positions = new Float32Array(bytesOf(part.positions).buffer);
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let at = 0; at < positions.length; ++at) {
      const axis = at % 3;
      const value = positions[at] + part.origin[axis];
      if (value < low[axis]) low[axis] = value;
      if (value > high[axis]) high[axis] = value;
    }
    return {
      name: part.name,
      fixture: part.fixture ?? false,
      origin: part.origin,
      turn: part.turn ?? UPRIGHT,
      positions,
      triangles: new Uint32Array(bytesOf(part.triangles).buffer),
      box: { low, high },
    };
  });
}

/** The document with the names that the page has for files of one name in several folders.
 * @param {import('./types').RunDocument} document @param {import('./types').Figures} figures
 * @returns {import('./types').RunDocument} */
export function named(document, { names }) {
  if (!names) return document;
  /** @template {{file?: string}} T @param {T[] | undefined} list @param {string[]} files @returns {T[]} */
  const each = (list, files) => (list ?? []).map((one, n) => (one.file && files[n] ? { ...one, file: files[n] } : one));
  const { touches, moves, calls, counts, collision } = document;
  return {
    ...document,
    touches: each(touches, names.touches),
    moves: each(moves, names.moves),
    calls: each(calls, names.calls),
    counts: each(counts, names.counts),
    collision: collision && names.collision ? { ...collision, file: names.collision } : collision,
  };
}
