// Legends of scene and time line, where the command has left room for them.
import { byId, esc } from './markup.js';
import { word } from './words.js';

/** @typedef {import('./types').Kind} Kind */
/** @typedef {import('./run').Run} Run */

/** @param {string} drawn @param {string} text */
const key = (drawn, text) => `<span class="key">${drawn}${esc(text)}</span>`;

const line = (/** @type {string} */ ink, width = 2, dashes = '') => `<svg width="22" height="8" aria-hidden="true"><path d="M0 4H22" `
  + `stroke="var(--${ink})" stroke-width="${width}"${dashes ? ` stroke-dasharray="${dashes}"` : ''}/></svg>`;

/** @param {boolean} compared */
function sceneLegend(compared) {
  const normal = '<svg width="22" height="10" aria-hidden="true"><circle cx="4" cy="5" r="3.2" fill="var(--ink)"/>'
    + '<path d="M4 5H20M16 2l4 3-4 3" fill="none" stroke="var(--ink)" stroke-width="1.3"/></svg>';
  const keys = [key(line('rapid', 2, '5 4'), word('rapid')), key(line('feed'), word('feed')), key(line('skip', 2.6), word('skip')),
    key(normal, word('contact_normal'))];
  if (compared) keys.push(key(line('accent', 1.4, '3 3'), word('other_run')));
  return keys.join('');
}

/** The bands of motion differ in height, too. @param {Run | null} other @param {boolean} goesBeyond whether a curve leaves its scale */
function timelineLegend(other, goesBeyond) {
  const heights = /** @type {[Kind, number][]} */ ([['rapid', 4], ['feed', 8], ['skip', 12]]);
  const keys = heights.map(([kind, height]) => key(`<svg width="14" height="12" aria-hidden="true"><rect y="${6 - height / 2}" width="14" `
    + `height="${height}" fill="var(--${kind})"/></svg>`, word(kind)));
  if (other) keys.push(key(line('accent', 1.3, '4 3'), word(other.hasTimes ? 'other_run' : 'other_run_untimed')));
  const beyond = !goesBeyond ? '' : key('<svg width="10" height="10" aria-hidden="true"><path d="M1 3h8l-4 5z" fill="var(--ink2)"/></svg>', word('beyond_scale'));
  return `<span class="right">${keys.join('')}${key('', word('positions_mm'))}${beyond}</span>`;
}

/** @param {Run | null} other @param {boolean} isCut whether a part is cut open @param {boolean} goesBeyond whether a curve leaves its scale */
export function drawLegends(other, isCut, goesBeyond) {
  const scene = byId('scenecap');
  if (scene && !scene.childElementCount) scene.innerHTML = sceneLegend(other != null);
  const sceneHead = byId('scenehead');
  if (sceneHead && sceneHead.childElementCount < 2) sceneHead.insertAdjacentHTML('beforeend', `<span class="sub noprint">${esc(word(isCut ? 'cut_drag_to_turn' : 'drag_to_turn'))}</span>`);
  const chart = byId('charthead');
  if (chart && chart.childElementCount < 2) chart.insertAdjacentHTML('beforeend', timelineLegend(other, goesBeyond));
}
