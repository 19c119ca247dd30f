/** A button that opens a list of buttons, or a short text, beside itself. The browser shuts it on
 * Escape and on a click elsewhere, and gives the focus back. */
import { make, newId } from "./element.js";

const gap = 4;

export interface Menu {
  readonly opener: HTMLButtonElement;
  readonly popover: HTMLElement;
}

/** `entries` name what they do. */
export function menu(label: string, entries: ReadonlyMap<string, () => void>): Menu {
  const buttons = [...entries].map(([entry, act]) => {
    const button = make("button", { type: "button" }, entry);
    button.addEventListener("click", () => {
      popover.hidePopover();
      act();
    });
    return button;
  });
  const { opener, popover } = popup(label, buttons);
  return { opener, popover };
}

/** Any content in place of buttons. */
export function popup(label: string, content: readonly Node[]): Menu {
  const id = newId();
  const popover = make("div", { class: "lab-menu", id, popover: true }, ...content);
  const opener = make("button", { type: "button", class: "menu-opener", popovertarget: id }, label);
  popover.addEventListener("toggle", ({ newState }) => {
    if (newState === "open") place(popover, opener);
  });
  return { opener, popover };
}

/** Under the opener where there is room, else above; never outside of the window. */
function place(popover: HTMLElement, opener: Element): void {
  const from = opener.getBoundingClientRect();
  const size = popover.getBoundingClientRect();
  const below = from.bottom + gap + size.height <= innerHeight;
  const top = below ? from.bottom + gap : Math.max(gap, from.top - gap - size.height);
  const left = Math.max(gap, Math.min(from.left, innerWidth - size.width - gap));
  popover.style.top = `${top}px`;
  popover.style.left = `${left}px`;
}
