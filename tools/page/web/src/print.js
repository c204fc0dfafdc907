// Paper: figures drawn for its width, in light colours, and all rows of the tables.

const PLAN = { width: 440, share: 0.69 }; // px of a column, height as a share of it
const TIMELINE = 900; // px

/**
 * @param {{plan: import('./plan').Plan, scene: import('./scene').Scene, timeline: import('./timeline').Timeline,
 *   listing: import('./listing').Listing, table: import('./touch_table').TouchTable}} page
 */
export function keepPrintable({ plan, scene, timeline, listing, table }) {
  let theme = '';
  const root = document.documentElement;
  addEventListener('beforeprint', () => {
    root.dataset.paper = ''; // a change of size is now that of the paper
    theme = root.dataset.theme ?? '';
    root.dataset.theme = 'light';
    plan.draw(PLAN.width, PLAN.share);
    timeline.draw(TIMELINE);
    scene.beforePrint(PLAN.width, PLAN.share);
    listing.beforePrint();
    table.beforePrint();
  });
  addEventListener('afterprint', () => {
    delete root.dataset.paper;
    if (theme) root.dataset.theme = theme;
    else delete root.dataset.theme;
    plan.draw();
    timeline.draw();
    scene.afterPrint();
    listing.afterPrint();
    table.afterPrint();
  });
}
