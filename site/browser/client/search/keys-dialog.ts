// The list of keys, and whether single ones act: readers who speak to their computer may not want
// them.

import { make } from "../element.js";
import { setSingleKeys, singleKeys } from "../single-keys.js";

const keys = [
  ["/", "search"],
  ["Ctrl + K", "search, from anywhere (⌘ K on a Mac)"],
  ["[", "previous lesson"],
  ["]", "next lesson"],
  ["?", "these keys"],
  ["Esc", "close what is open"],
] as const;

export class KeysDialog {
  readonly #switch = make("input", { type: "checkbox" });
  readonly #dialog = make("dialog", { class: "keys", "aria-labelledby": "keys-title" });

  constructor() {
    const list = make("dl");
    for (const [key, what] of keys) {
      list.append(make("dt", {}, make("kbd", {}, key)), make("dd", {}, what));
    }
    const close = make("button", { type: "button" }, "Close");
    close.addEventListener("click", () => this.#dialog.close());
    this.#switch.addEventListener("change", () => setSingleKeys(this.#switch.checked));
    this.#dialog.append(
      make("h2", { id: "keys-title" }, "Keys"),
      list,
      make("p", {}, "A lab has keys of its own while the focus is in it; its menu lists them."),
      make("label", {}, this.#switch, " Single keys act: / [ ] ?"),
      close,
    );
    document.body.append(this.#dialog);
  }

  open(): void {
    this.#switch.checked = singleKeys();
    if (!this.#dialog.open) this.#dialog.showModal();
  }
}
