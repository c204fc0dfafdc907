// A page that g31 view serves makes way for the next edition, and what its reader has chosen stays.
import { byId } from './markup.js';
import { word } from './words.js';

const KEPT = 'g31-kept';

/** @typedef {{theme: string, scroll: [number, number], listing: number, touch: number | null, time: number | null}} Kept */

/** @returns {Kept | null} what the edition before this one has left */
function kept() {
  try {
    return JSON.parse(sessionStorage.getItem(KEPT) ?? 'null');
  } catch {
    return null; // a browser may have no storage here
  }
}

const isServed = () => document.documentElement.dataset.edition != null;

/** Before anything is drawn. */
export function restoreTheme() {
  const theme = isServed() ? kept()?.theme : '';
  if (theme) document.documentElement.dataset.theme = theme;
}

/** @param {import('./choice').Choice} choice @param {Kept} was */
function restore(choice, was) {
  if (was.touch != null) choice.choose(was.touch);
  if (was.time != null) choice.moveTo(was.time);
  const listing = byId('listing');
  if (listing) listing.scrollTop = was.listing;
  history.scrollRestoration = 'manual';
  scrollTo(...was.scroll);
}

/** Shows what the server is at, above the page. @returns {(text: string) => void} '': nothing */
function notice() {
  const note = document.createElement('p');
  note.className = 'live noprint';
  note.setAttribute('role', 'status');
  note.hidden = true;
  document.body.append(note);
  return (text) => {
    note.textContent = text;
    note.hidden = text === '';
  };
}

/** A run that is over at once needs no word. */
const SHORT_RUN_MS = 400;

/** @param {EventSource} events */
function showState(events) {
  const say = notice();
  let waits = 0;
  events.addEventListener('works', () => {
    waits = window.setTimeout(() => say(word('view_works')), SHORT_RUN_MS);
  });
  events.onerror = () => {
    clearTimeout(waits);
    say(word('view_ended'));
  };
  events.onopen = () => say('');
}

/** @param {import('./choice').Choice} choice */
export function followEditions(choice) {
  const { edition } = document.documentElement.dataset;
  if (edition == null) return;
  const first = { touch: choice.touch, time: choice.time };
  const was = kept();
  if (was) restore(choice, was);
  const events = new EventSource(`/events${location.search}`);
  showState(events);
  events.onmessage = ({ data }) => {
    if (data === edition) return;
    events.close();
    // What nobody has chosen follows the new run.
    /** @type {Kept} */
    const keep = {
      theme: document.documentElement.dataset.theme ?? '',
      scroll: [scrollX, scrollY],
      listing: byId('listing')?.scrollTop ?? 0,
      touch: choice.touch === first.touch ? was?.touch ?? null : choice.touch,
      time: choice.time === first.time ? was?.time ?? null : choice.time,
    };
    try {
      sessionStorage.setItem(KEPT, JSON.stringify(keep));
    } catch { /* then the new edition begins as the first one did */ }
    location.reload();
  };
}
