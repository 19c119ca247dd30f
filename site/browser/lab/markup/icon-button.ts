/** A button with a sign in place of a word; its name is heard, and shown under the pointer. */
import { make } from "./element.js";
import { type Icon, icon } from "./icon.js";

export interface IconButtonOptions {
  readonly name: string;
  readonly icon: Icon;
  /** As aria-keyshortcuts has them: "Space K". */
  readonly keys?: string;
  /** Further classes. */
  readonly classes?: string;
  readonly act: () => void;
}

export function iconButton(options: IconButtonOptions): HTMLButtonElement {
  const { name, keys, classes = "", act } = options;
  const button = make("button", { type: "button", class: `icon-button ${classes}`.trim() });
  if (keys !== undefined) button.setAttribute("aria-keyshortcuts", keys);
  rename(button, name, options.icon);
  button.addEventListener("click", act);
  return button;
}

/** Does nothing where the button already has that name. */
export function rename(button: HTMLButtonElement, name: string, sign: Icon): void {
  if (button.ariaLabel === name) return;
  button.ariaLabel = name;
  button.title = name;
  button.replaceChildren(icon(sign));
}
