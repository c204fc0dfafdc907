// Boxes that scroll by themselves say where more of them lies: they fade out there.

/** @param {Element} box */
function mark(box) {
  box.classList.toggle('beside', box.scrollLeft + box.clientWidth < box.scrollWidth - 1);
  box.classList.toggle('below', box.scrollTop + box.clientHeight < box.scrollHeight - 1);
}

export function markOverflow() {
  const watch = new ResizeObserver((entries) => {
    for (const { target } of entries) mark(target.matches('.drawing, .tw') ? target : target.parentElement ?? target);
  });
  for (const box of document.querySelectorAll('.drawing, .tw')) {
    box.addEventListener('scroll', () => mark(box), { passive: true });
    watch.observe(box);
    for (const content of box.children) watch.observe(content);
  }
}
