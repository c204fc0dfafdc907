// A page as the command writes one, for a run of sample_run.mjs: the markup that the script relies on.
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';

const VIRTUAL_PAST = 2000; // rows
const PACKED_PAST = 1 << 20; // bytes

const esc = (text) => String(text).replace(/[&<>"']/g, (sign) => `&#${sign.charCodeAt(0)};`);
const num = (value, digits = 3) => (value == null ? '–' : value.toFixed(digits).replace('-', '−'));

function data(id, value) {
  const text = JSON.stringify(value).replace(/</g, '\\u003c');
  return text.length < PACKED_PAST ? `<script type="application/json" id="${id}">${text}</script>`
    : `<script type="text/plain" id="${id}" data-encoding="gzip">${zlib.gzipSync(text, { level: 9 }).toString('base64')}</script>`;
}

function touchTable({ document, figures }) {
  const long = document.touches.length > VIRTUAL_PAST;
  const rows = long ? '' : document.touches.map((touch, n) => {
    const figure = figures.touch?.[n] ?? { deviation: null, angle: null, role: '' };
    const cells = (point) => (point ?? [null, null, null]).map((v) => `<td class="n">${num(v)}</td>`).join('');
    return `<tr data-touch="${n + 1}" class="${touch.triggered ? '' : 'un'}"><td class="stick"><button class="badge" data-t="${n + 1}" `
      + `aria-label="Touch ${n + 1}">${n + 1}</button></td><td><a href="#L-${touch.file}-${touch.line}" data-go="${touch.file}:${touch.line}">`
      + `${touch.file}:${touch.line}</a> <span class="mut">${touch.block}</span></td><td class="n">${num(touch.time_s)}</td><td class="n">${touch.feed}</td>`
      + `${cells(touch.commanded)}${cells(touch.work)}<td>${esc(touch.part ?? '–')}</td>${cells(touch.contact)}<td class="n">`
      + `${figure.deviation == null ? '–' : num(figure.deviation * 1000, 1)}</td><td class="n">${num(figure.angle, 1)}</td><td>${figure.role}</td></tr>`;
  }).join('');
  const heads = ['No.', 'Block', 'Time s', 'Feed', 'X', 'Y', 'Z', 'X', 'Y', 'Z', 'Part', 'X', 'Y', 'Z', 'Dev. µm', 'Angle °', 'Role'];
  return `<section class="card" aria-labelledby="hto"><header><h2 id="hto">Touches</h2><span class="sub">every skip move</span><span class="right">`
    + '<label class="key noprint"><input type="checkbox" id="allt"> also ways without a signal</label></span></header>'
    + `<div class="tw tall" tabindex="0" role="region" aria-label="Touches, table"><table id="touches"><thead><tr>${heads.map((h) => `<th>${h}</th>`).join('')}`
    + `</tr></thead><tbody${long ? ' data-virtual' : ''}>${rows}</tbody></table></div></section>`;
}

function listing({ document, figures }) {
  const lists = figures.listing.map(({ file, text }) => {
    const lines = text.split('\n');
    if (lines.length > VIRTUAL_PAST) return `<h3 class="vh">${esc(file)}</h3><ol data-file="${esc(file)}" data-virtual data-rows="${lines.length}"></ol>`;
    const counted = document.counts.find((each) => each.file === file)?.lines ?? {};
    return `<h3 class="vh">${esc(file)}</h3><ol data-file="${esc(file)}">${lines.map((line, n) => `<li id="L-${esc(file)}-${n + 1}" data-l="${n + 1}" class="`
      + `${counted[n + 1] == null ? '' : counted[n + 1] ? 'x' : 'z'}"><span class="ct">${counted[n + 1] ?? ''}</span><span class="no">${n + 1}</span>`
      + `<span class="tx">${esc(line) || ' '}</span><span class="tb"></span></li>`).join('')}</ol>`;
  }).join('');
  const tabs = figures.listing.map(({ file }) => `<button data-file="${esc(file)}">${esc(file)}</button>`).join('');
  return '<div class="two text"><section class="card flow" aria-labelledby="hli"><header><h2 id="hli">Program</h2>'
    + `<span class="seg noprint" role="group" aria-label="File" id="ltabs">${tabs}</span></header><div class="lst" id="listing" tabindex="0" role="region" `
    + `aria-label="Program listing with counts">${lists}</div></section><section class="card" id="variables" aria-labelledby="hva"><header>`
    + '<h2 id="hva">Variables</h2></header><p class="limits">The run wrote none.</p></section></div>';
}

function figuresOf(run) {
  const key = (ink, text) => `<span class="key"><svg width="18" height="8" aria-hidden="true"><path d="M0 4H18" stroke="var(--${ink})" stroke-width="2"/></svg>${text}</span>`;
  return '<div class="two"><section class="card" aria-label="Plan view"><header id="planhead"></header><div id="plan"></div><div class="cap" id="plancap">'
    + '</div></section><section class="card" aria-labelledby="hsc"><header><h2 id="hsc">Scene</h2><span class="sub">cut open towards you<span class="noprint">, '
    + `drag to turn</span></span></header><div id="scenebox"></div><div class="cap">${key('rapid', 'rapid')}${key('feed', 'feed')}${key('skip', 'skip move')}</div>`
    + `</section></div><section class="card" aria-labelledby="htl"><header><h2 id="htl">Time line</h2></header><div id="chart"></div></section>`
    + '<div class="transport noprint" role="group" aria-label="Play the run"><div class="ctl"><button class="btn" id="prev" aria-label="Touch before, key [">'
    + '<svg viewBox="0 0 16 16"><path d="M2 2h2v12H2zM14 1.5v13L5 8z"/></svg></button><button class="btn" id="play" aria-label="Play"><svg viewBox="0 0 16 16">'
    + '<path d="M3 1.5l11 6.5-11 6.5z"/></svg></button><button class="btn" id="next" aria-label="Next touch, key ]"><svg viewBox="0 0 16 16">'
    + '<path d="M12 2h2v12h-2zM2 1.5v13L11 8z"/></svg></button><select class="btn" id="rate" aria-label="Speed"><option value="1">1×</option>'
    + `<option value="4" selected>4×</option><option value="16">16×</option></select></div><input type="range" id="timeline" min="0" max="${run.document.machine_time_s}" `
    + 'step="0.001" aria-label="Time in the run"><div class="now" id="now"></div></div>';
}

/** @param {{document: any, figures: any}} run @param {string} bundle folder of page.js and page.css */
export function samplePage(run, bundle) {
  const css = fs.readFileSync(path.join(bundle, 'page.css'), 'utf8');
  const script = fs.readFileSync(path.join(bundle, 'page.js'), 'utf8');
  const { program } = run.document;
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">`
    + `<title>${program}: g31 run report</title><style>${css}</style></head><body><a class="skip" href="#touches">Skip to touches</a><div class="wrap" id="main">`
    + `<header class="top"><span class="brand">g31</span><h1 id="doc">${program}</h1><span class="what">sample</span><span class="tools noprint">`
    + '<button class="btn" id="theme">Light or dark</button><button class="btn" id="print">Print</button></span></header><main>'
    + '<section id="summary" class="card" aria-labelledby="headline"><div class="verdict good"><div class="vmain"><div><div class="state">Completed</div>'
    + '<h2 class="headline" id="headline">The run came to its end.</h2></div><p>A run in closed form.</p></div></div><div class="cmd"><span class="lab">Repeat it'
    + '</span><pre id="command">g31 run main.nc \\\n  --report main.html</pre><button class="btn noprint" id="copy">Copy</button></div></section>'
    + `${figuresOf(run)}${touchTable(run)}${listing(run)}</main></div>${data('g31-document', run.document)}${data('g31-figures', run.figures)}`
    + `<script>${script}</script></body></html>`;
}
