// What a term means, beside it: while the pointer is on it or the keyboard has come to it. Without
// this script the browser shows the same in its own way.

const delay = 150; // ms, so that a pointer on its way elsewhere opens nothing

const card = document.createElement("div");
card.id = "term-card";
card.className = "term-card";
card.role = "tooltip";
card.popover = "manual";
const text = card.appendChild(document.createElement("p"));

let shown: HTMLAnchorElement | null = null;
let waiting = 0;

function hide() {
  clearTimeout(waiting);
  shown?.removeAttribute("aria-describedby");
  shown = null;
  if (card.isConnected) card.hidePopover();
}

// Below the term, or above it where there is more room; never out of the window.
function place(term: HTMLAnchorElement) {
  const line = term.getClientRects()[0] ?? term.getBoundingClientRect();
  const { width, height } = card.getBoundingClientRect();
  const wide = document.documentElement.clientWidth;
  const below = line.bottom + height <= document.documentElement.clientHeight;
  card.style.left = `${Math.max(0, Math.min(line.left, wide - width))}px`;
  card.style.top = `${below || line.top < height ? line.bottom : line.top - height}px`;
}

function show(term: HTMLAnchorElement) {
  hide();
  if (term.title) {
    term.dataset["meaning"] = term.title;
    term.removeAttribute("title");
  }
  if (!term.dataset["meaning"]) return;
  if (!card.isConnected) document.body.append(card);
  text.textContent = term.dataset["meaning"];
  term.setAttribute("aria-describedby", card.id);
  card.showPopover();
  place(term);
  shown = term;
}

const termOf = (target: EventTarget | null) =>
  target instanceof Element ? target.closest<HTMLAnchorElement>("a.term") : null;

export function explainTerms() {
  document.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    const term = termOf(event.target);
    clearTimeout(waiting);
    if (term === shown && term) return;
    // The pointer may go over to the card and rest there.
    const onCard = event.target instanceof Node && card.contains(event.target);
    if (term) waiting = window.setTimeout(() => show(term), delay);
    else if (shown && !onCard && shown !== document.activeElement)
      waiting = window.setTimeout(hide, delay);
  });
  document.addEventListener("focusin", (event) => {
    const term = termOf(event.target);
    if (term?.matches(":focus-visible")) show(term);
    else hide();
  });
  document.addEventListener("focusout", hide);
  document.addEventListener("scroll", hide, { passive: true });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
}
