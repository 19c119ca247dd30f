// What a page in preview has beside its own scripts: it stays the newest one.
//
// News of a version makes it ask for its state; what is another then is put in place, and the rest
// is left alone: the place that was scrolled to, a running lab, answers, open callouts.

import { followContents } from "../client/contents.js";
import { addCopyButtons } from "../client/copying.js";
import { numberLines } from "../client/lines.js";
import { startParts } from "../client/parts.js";
import { offerPrograms } from "../client/programs.js";
import { upgradeQuizzes } from "../client/quiz/quiz.js";
import { reachScrollers } from "../client/scrollers.js";
import { markParts } from "./marks.js";
import { hearNews } from "./news.js";
import { Panel } from "./panel.js";
import { Parts } from "./parts.js";
import { renewPictures } from "./pictures.js";
import { askState, type State } from "./state.js";
import { Styles } from "./styles.js";

// Which page this is, as the server calls it; "" where there was none.
const loaded = document.currentScript?.dataset["page"] ?? "";

class Preview {
  readonly #parts = new Parts();
  readonly #panel = new Panel();
  readonly #styles = new Styles();
  #known = loaded;
  #asking = false;
  #stale = false;

  async renew(): Promise<void> {
    this.#stale = true;
    if (this.#asking) return;
    this.#asking = true;
    try {
      while (this.#stale) {
        this.#stale = false;
        this.#show(await askState(this.#known, this.#styles.worn));
      }
    } catch {
      this.#panel.gone();
    } finally {
      this.#asking = false;
    }
  }

  gone(): void {
    this.#panel.gone();
  }

  #show(state: State): void {
    const { html, change } = state;
    const page = html && new DOMParser().parseFromString(html, "text/html");
    // From no page to one, or from one kind of page to another.
    if (page && page.body.className !== document.body.className) {
      location.reload();
      return;
    }
    if (html !== "") this.#known = state.hash;
    if (page) {
      document.title = page.title;
      this.#styles.take(page);
      this.#put(() => this.#parts.replace(page));
    }
    if (change) this.#put(() => this.#parts.change(change));
    if (state.css !== null) this.#styles.wear(state.stylesheet, state.css);
    renewPictures(state.pictures);
    markParts(this.#parts.text(), state, (one) => this.#panel.open(one));
    this.#panel.show(state);
    document.documentElement.dataset["previewVersion"] = String(state.version);
  }

  /** What `put` puts in place becomes what the page's own script makes of it in a page. */
  #put(put: () => readonly Element[]): void {
    const stay = stayInPlace();
    const elements = put();
    const upgrades = [upgradeQuizzes, addCopyButtons, numberLines, offerPrograms, reachScrollers];
    for (const element of elements) {
      startParts(...upgrades.map((upgrade) => () => upgrade(element)));
    }
    if (elements.some((element) => element.matches(".contents, .prose > *"))) followContents();
    stay();
  }
}

/** What stands at the window's upper edge still does when the function it gives is called. */
function stayInPlace(): () => void {
  if (scrollY === 0) return () => undefined;
  const parts = [...document.querySelectorAll(".prose > *, main > *")];
  const edges = parts
    .map((part) => ({ part, top: part.getBoundingClientRect().top }))
    .filter(({ part, top }) => top + part.clientHeight > 0 && part.clientHeight < innerHeight);
  return () => {
    const edge = edges.find(({ part }) => part.isConnected);
    if (edge)
      scrollBy({ top: edge.part.getBoundingClientRect().top - edge.top, behavior: "instant" });
  };
}

function loadStyles(): void {
  const link = document.createElement("link");
  link.rel = "stylesheet";
  link.href = "/.preview/preview.css";
  document.head.append(link);
}

// This runs before the page's own script has changed anything.
document.addEventListener("DOMContentLoaded", () => {
  loadStyles();
  const preview = new Preview();
  hearNews((news) => (news === "gone" ? preview.gone() : void preview.renew()));
});
