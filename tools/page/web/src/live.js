// A page that g31 view serves makes way for the next edition, and what its reader has chosen stays.
import { byId } from './markup.js';

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

/** @param {import('./choice').Choice} choice */
export function followEditions(choice) {
  const { edition } = document.documentElement.dataset;
  if (edition == null) return;
  const first = { touch: choice.touch, time: choice.time };
  const was = kept();
  if (was) restore(choice, was);
  const events = new EventSource(`/events${location.search}`);
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
