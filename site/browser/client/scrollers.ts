// What is wider than its column scrolls alone; here it is made reachable with the keyboard, and only
// while it does scroll, so that the Tab key does not stop where there is nothing to do.

// With a formula in a line, which may be wider than that (math.css).
const withFormula = ".prose :is(p, ul, ol, dl, h2, h3, h4, summary):has(.math.wide)";
const scrollers = `.table, .math.display, pre, ${withFormula}`;

function update(element: Element): void {
  const { scrollWidth, clientWidth, scrollHeight, clientHeight } = element;
  const scrolls =
    getComputedStyle(element).overflowX !== "visible" &&
    (scrollWidth > clientWidth || (scrollHeight > clientHeight && !element.matches(withFormula)));
  if (scrolls) element.setAttribute("tabindex", "0");
  else element.removeAttribute("tabindex");
}

/** Those in `root`, which may be one itself. */
export function reachScrollers(root: Document | Element = document): void {
  const observer = new ResizeObserver((entries) => {
    for (const { target } of entries) update(target);
  });
  const all = [...root.querySelectorAll(scrollers)];
  if (root instanceof Element && root.matches(scrollers)) all.push(root);
  for (const element of all) observer.observe(element);
}
