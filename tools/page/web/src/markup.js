// Numbers, texts and elements as the page shows them.

/** @type {Record<string, string>} */
const ENTITIES = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };

/** Program text is only ever text. @param {unknown} text */
export const esc = (text) => String(text).replace(/[&<>"']/g, (sign) => ENTITIES[sign]);

/**
 * A number with a real minus sign; missing is a dash, never 0.
 * @param {number | null | undefined} value
 * @param {number} [decimals]
 * @param {boolean} [signed] whether a plus is shown, too
 */
export function num(value, decimals = 3, signed = false) {
  if (value == null || !Number.isFinite(value)) return '–';
  const visible = Math.abs(value) >= 0.5 * 10 ** -decimals;
  const sign = visible && value < 0 ? '−' : visible && signed ? '+' : '';
  return sign + Math.abs(value).toFixed(decimals);
}

/** Micrometres of a length in mm. @param {number | null | undefined} mm */
export const um = (mm) => (mm == null ? '–' : num(mm * 1000, 1, true));

/** @param {number} value @param {number} low @param {number} high */
export const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

/** @param {string} id */
export const byId = (id) => document.getElementById(id);

/**
 * A step of 1, 2 or 5 times a power of ten that is at least as long as wanted.
 * @param {number} atLeast over 0
 */
export function niceStep(atLeast) {
  const power = 10 ** Math.floor(Math.log10(atLeast));
  return power * ([1, 2, 5, 10].find((factor) => factor * power >= atLeast * (1 - 1e-9)) ?? 10);
}

/** As many decimals as a step of this length needs. @param {number} step */
export const decimalsOf = (step) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

/**
 * As few decimals as tell a value that well. @param {number} value @param {number} within over 0
 */
export function decimalsWithin(value, within) {
  let decimals = 0;
  while (decimals < 6 && Math.abs(value - Number(value.toFixed(decimals))) > within) ++decimals;
  return decimals;
}

/** px from the middle of such a circle to its end. @param {number} number of the touch */
export const markHalf = (number) => Math.max(8.5, 5 + String(number).length * 3.2);

/**
 * The number of a touch as a circle in a drawing.
 * @param {import('./types').Contact} contact
 * @param {number} x @param {number} y
 * @param {boolean} chosen
 */
export function mark(contact, x, y, chosen) {
  const text = String(contact.number);
  const half = markHalf(contact.number);
  const edge = chosen ? 'var(--accent)' : contact.counts ? 'var(--ink)' : 'var(--ink3)';
  const ink = chosen ? 'var(--paper)' : contact.counts ? 'var(--ink)' : 'var(--ink2)';
  return `<g data-t="${contact.number}" style="cursor:pointer"><rect x="${(x - half).toFixed(1)}" `
    + `y="${(y - 8.5).toFixed(1)}" width="${2 * half}" height="17" rx="8.5" fill="${chosen ? 'var(--accent)' : 'var(--paper)'}" `
    + `stroke="${edge}" stroke-width="1.3"/><text x="${x.toFixed(1)}" y="${(y + 3.9).toFixed(1)}" font-size="11" `
    + `font-weight="${contact.counts || chosen ? 650 : 500}" text-anchor="middle" fill="${ink}">${text}</text></g>`;
}
