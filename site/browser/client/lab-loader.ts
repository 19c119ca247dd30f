// Makes a lab's picture live. Until then it is a picture with a Play button. The engine is large, so
// it is loaded when the reader presses Play, or when the page is idle, the lab is near, and the
// reader has moved at all. A page that was opened and left needs no running simulator. A large model
// waits for Play, since all labs of a page share the engine's memory.
//
// Where it cannot be loaded the picture stays, and one line says why and what to do. What happens
// once it is loaded is in lab/lab.ts, which this script knows only by its address.

import { whenNear } from "./near.js";

interface LabHandle {
  play(): void;
}

interface LabCode {
  readonly openLab: (element: HTMLElement) => Promise<LabHandle>;
}

const reasons = {
  file:
    "A lab runs only on a page that a web server gave. In the site’s folder, run " +
    "“python3 -m http.server” and open http://localhost:8000.",
  noWebAssembly:
    "This browser has no WebAssembly, or it is switched off, so the lab stays a picture. " +
    "Another browser may run it.",
  network: "The lab could not be loaded. Check the connection, then reload the page.",
  unknown: "The lab could not be started, and the browser’s console tells why.",
} as const;

class SimLab extends HTMLElement {
  readonly #play = document.createElement("button");
  readonly #status = document.createElement("p");
  #opening: Promise<LabHandle> | undefined;

  connectedCallback(): void {
    const { code, module } = this.dataset;
    const view = this.querySelector(":scope > figure > .lab-view");
    if (!code || !module || !view || this.#play.isConnected) return;
    this.#play.type = "button";
    this.#play.className = "lab-play";
    this.#play.textContent = "Play";
    this.#play.addEventListener("click", () => void this.#playOnceOpen());
    this.#status.className = "lab-status";
    this.#status.setAttribute("role", "status");
    view.append(this.#play);
    view.after(this.#status);
    if (savesData() || "large" in this.dataset) return;
    const open = (): void => void this.#open().catch(() => undefined);
    onFirstMove(() => whenNear(this, () => whenIdle(open)));
  }

  async #playOnceOpen(): Promise<void> {
    if (this.#play.ariaBusy === "true") return;
    this.#play.ariaBusy = "true";
    this.#play.textContent = "Loading MuJoCo…";
    try {
      (await this.#open()).play();
    } catch {
      // #open() has said why.
    }
  }

  #open(): Promise<LabHandle> {
    this.#opening ??= this.#load().catch((error: unknown) => {
      if (isNamed(error, "NoMemory") && this.#play.ariaBusy !== "true") {
        this.#opening = undefined; // nobody asked for it yet, and then there may be memory
        throw error;
      }
      const focused = this.#play.matches(":focus");
      this.#play.remove();
      this.#status.textContent = reasonOf(error);
      this.dataset["refused"] = "";
      if (focused) this.#status.tabIndex = -1;
      if (focused) this.#status.focus();
      throw error;
    });
    return this.#opening;
  }

  async #load(): Promise<LabHandle> {
    if (location.protocol === "file:") throw new Refusal(reasons.file);
    if (typeof WebAssembly !== "object") throw new Refusal(reasons.noWebAssembly);
    const address = new URL(this.dataset["code"]!, document.baseURI).href;
    const { openLab } = await this.#code(address);
    return openLab(this);
  }

  async #code(address: string): Promise<LabCode> {
    try {
      return (await import(address)) as LabCode;
    } catch (cause) {
      reportError(cause);
      throw new Refusal(reasons.network);
    }
  }
}

/** Its message is for the reader. */
class Refusal extends Error {
  override readonly name = "Refusal";
}

function reasonOf(error: unknown): string {
  if (isNamed(error, "Refusal") || isNamed(error, "NoMemory")) return error.message;
  reportError(error);
  return reasons.unknown;
}

/** lab.ts has classes of its own: what it throws is told by its name. */
function isNamed(error: unknown, name: string): error is Error {
  return error instanceof Error && error.name === name;
}

function savesData(): boolean {
  const { connection } = navigator as { connection?: { readonly saveData?: boolean } };
  return connection?.saveData === true;
}

/** A scroll is none: the browser itself scrolls to where a reader was before a reload. */
function onFirstMove(act: () => void): void {
  const listening = new AbortController();
  const move = (): void => {
    listening.abort();
    act();
  };
  for (const kind of ["pointermove", "pointerdown", "keydown", "wheel"]) {
    addEventListener(kind, move, { capture: true, passive: true, signal: listening.signal });
  }
}

function whenIdle(act: () => void): void {
  // Safari has no idle callbacks.
  const hasIdle = Object.hasOwn(window, "requestIdleCallback");
  if (document.readyState !== "complete") addEventListener("load", () => whenIdle(act));
  else if (hasIdle) requestIdleCallback(act, { timeout: 2000 });
  else setTimeout(act, 200);
}

/** Once the document is there: an element that is defined earlier has no children yet. */
export function upgradeLabs(): void {
  customElements.define("sim-lab", SimLab);
}
