// Marks, in the list of contents, the section that is being read.

// A heading counts as reached once it is this far from the top of the window, in pixels.
const reached = 160;

interface Section {
  heading: HTMLElement;
  link: HTMLAnchorElement;
}

function sections(): Section[] {
  const links = document.querySelectorAll<HTMLAnchorElement>(".contents a[href^='#']");
  return [...links].flatMap((link) => {
    const heading = document.getElementById(decodeURIComponent(link.hash.slice(1)));
    return heading ? [{ heading, link }] : [];
  });
}

export function followContents(): void {
  const all = sections();
  let marked: HTMLAnchorElement | undefined;
  let waiting = false;

  const mark = (): void => {
    waiting = false;
    const now = all.findLast(({ heading }) => heading.getBoundingClientRect().top < reached);
    if (now?.link === marked) return;
    marked?.removeAttribute("aria-current");
    marked = now?.link;
    marked?.setAttribute("aria-current", "true");
  };

  if (all.length === 0) return;
  addEventListener(
    "scroll",
    () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(mark);
    },
    { passive: true },
  );
  mark();
}
