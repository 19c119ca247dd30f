/** What the page's address brings to a lab, which is for its reader to say: what it is, how large, and
 * nothing of it is looked at before they want it. */
import { make } from "../markup/element.js";
import type { LinkHead } from "../run/lab-link.js";
import { Unreachable } from "../run/resources.js";

export class LinkOffer {
  readonly element = make("div", { class: "lab-offer", role: "group", "aria-label": "A link" });
  readonly #status = make("p", { role: "status" });
  readonly #load = make("button", { type: "button", class: "lab-button" }, "Load it");
  readonly #left = new AbortController();

  /** `load` gives why it was not loaded, as a clause; `leave` is called when the reader wants none of it. */
  constructor(
    head: LinkHead,
    load: (signal: AbortSignal) => Promise<string | undefined>,
    leave: () => void,
  ) {
    const leaveIt = make("button", { type: "button", class: "lab-button" }, "Leave it");
    this.#load.addEventListener("click", () => void this.#answer(load));
    leaveIt.addEventListener("click", () => {
      this.close();
      leave();
    });
    const buttons = make("p", {}, this.#load, " ", leaveIt);
    this.element.append(make("p", {}, wordsOn(head)), this.#status, buttons);
  }

  close(): void {
    this.#left.abort();
    this.element.remove();
  }

  async #answer(load: (signal: AbortSignal) => Promise<string | undefined>): Promise<void> {
    this.#load.disabled = true;
    this.#status.textContent = "Trying it apart from this page…";
    const fault = await load(this.#left.signal).catch(whyNot);
    if (fault === undefined) this.close();
    else this.#status.textContent = `It was not loaded: ${fault}.`.replace(/\.\.$/, ".");
  }
}

function whyNot(error: unknown): string {
  if (error instanceof Unreachable) return error.message;
  reportError(error);
  return "the browser’s console tells why";
}

function wordsOn({ mjcfBytes, characters }: LinkHead): string {
  if (mjcfBytes === 0) {
    return `The link brings a state of this lab that somebody else has left: ${characters} characters.`;
  }
  const size = mjcfBytes < 1000 ? `${mjcfBytes} bytes` : `${(mjcfBytes / 1000).toFixed(1)} kB`;
  return `The link brings a state of this lab, and a model that somebody else may have written: ${size} of MJCF.`;
}
