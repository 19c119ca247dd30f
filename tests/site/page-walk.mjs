// The way through the pages of a site, several at a time, on which checks look at them (pages.mjs).
//
// Enter at run(); then conclude() for each check, and `problems`. What the browser complains of while a page
// is open is a problem of that page, and no look at it counts as good.

import { globSync, readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join } from "node:path";

import { Visitor, documents, movedPages, pages } from "./browser.mjs";
import { launch } from "./chromium.mjs";
import { PageStamps } from "./page-stamps.mjs";
import { serve } from "./server.mjs";
import { Visit } from "./visit.mjs";

// As most readers see a page, with the fewest means, and for one who saves data, as no lab goes live there
// by itself. `source` is its HTML without a browser.
const views = {
  source: undefined,
  light: { scheme: "light", width: 1440 },
  plain: { scheme: "dark", width: 1440, javaScript: false },
  saver: { scheme: "light", width: 1440, savesData: true },
};

const patience = 120_000; // ms; the course as one document is long, and machines are busy

// What stays open; the course as one document; what leads on to another page; what stands for one.
function kindOf(path) {
  if (pages.includes(path)) return "page";
  if (documents.includes(path)) return "document";
  return movedPages.includes(path) ? "moved" : "missing";
}

export class Walk {
  problems = [];
  #folder;
  #checks;
  #stamps;
  #counts = new Map();
  #facts = new Map(); // of each check's name, of each view, by path

  constructor(folder, checks) {
    this.#folder = folder;
    this.#checks = checks;
    this.#stamps = new PageStamps(folder);
    for (const { name, looks } of checks) {
      this.#counts.set(name, { looks: 0, anew: 0 });
      const byView = Object.keys(looks).map((view) => [view, new Map()]);
      this.#facts.set(name, Object.fromEntries(byView));
    }
  }

  // How many looks of that check there are, and how many were done anew.
  countsOf(name) {
    return this.#counts.get(name);
  }

  async run() {
    const paths = globSync("**/*.html", { cwd: this.#folder }).sort();
    const visits = paths.flatMap((path) => this.#visitsTo(path));
    const inBrowser = visits.filter(({ view }) => views[view]);
    for (const visit of visits.filter(({ view }) => !views[view])) {
      await this.#look(undefined, visit);
      this.#keepGood(visit);
    }
    if (inBrowser.length > 0) await this.#open(inBrowser);
  }

  // The visits to a page on which something has to be looked at.
  #visitsTo(path) {
    const html = readFileSync(join(this.#folder, path), "utf8");
    const interested = this.#checks.filter(
      ({ kinds, concerns }) => kinds.includes(kindOf(path)) && concerns(html),
    );
    return Object.keys(views).flatMap((view) => {
      const all = interested.filter(({ looks }) => looks[view]);
      const looks = all
        .map((check) => ({ check, stamp: this.#stamps.nameOf(check, view, path, html) }))
        .filter((look) => !this.#isKnown(look, view, path));
      return looks.length > 0 ? [new Visit(this.#folder, view, path, html, looks)] : [];
    });
  }

  // Whether a stamp has the facts already; then they are kept.
  #isKnown({ check: { name }, stamp }, view, path) {
    const counts = this.#counts.get(name);
    ++counts.looks;
    const known = this.#stamps.find(stamp);
    if (known === undefined) ++counts.anew;
    else this.#facts.get(name)[view].set(path, known.facts);
    return known !== undefined;
  }

  async #open(visits) {
    const server = await serve(this.#folder);
    const browser = await launch();
    const work = async () => {
      for (let visit = visits.shift(); visit; visit = visits.shift()) {
        await this.#openOne(visit, new Visitor(browser, server.root));
      }
    };
    try {
      await Promise.all(Array.from({ length: availableParallelism() }, work));
    } finally {
      await browser.close();
      server.close();
    }
  }

  async #openOne(visit, visitor) {
    const { path, view } = visit;
    visit.root = visitor.address("");
    const before = (page) => {
      page.setDefaultTimeout(patience);
      page.on("request", (request) => visit.requests.push(request));
    };
    await visitor
      .visit(path, { ...views[view], before }, (page) => this.#look(page, visit))
      .catch((error) => visitor.complain(path, `the visit was broken off: ${error.message}`));
    for (const problem of visitor.problems) {
      this.problems.push(`browser: (${view}) ${problem}`);
    }
    if (visitor.problems.length === 0) this.#keepGood(visit);
  }

  async #look(page, visit) {
    const { path, view } = visit;
    for (const look of visit.looks) {
      const { name, looks } = look.check;
      const expect = (good, what) => {
        if (!good) look.problems.push(`${name}: ${path} (${view}): ${what}`);
      };
      look.problems = [];
      try {
        const facts = await looks[view](page, visit.toldWith(expect));
        this.#facts.get(name)[view].set(path, (look.facts = facts ?? null));
      } catch (error) {
        expect(false, `broken off: ${error.message}`);
      }
      this.problems.push(...look.problems);
      await page?.setViewportSize({ width: views[view].width, height: 900 });
      await page?.emulateMedia({ media: "screen", colorScheme: views[view].scheme });
    }
  }

  #keepGood({ looks, files }) {
    for (const { stamp, problems, facts } of looks) {
      if (problems?.length === 0) this.#stamps.put(stamp, files(), facts);
    }
  }

  // Says what a check finds of the whole site, once it has looked at all of it.
  conclude({ name, conclude }) {
    const facts = this.#facts.get(name);
    const found = Object.values(facts).reduce((sum, byPath) => sum + byPath.size, 0);
    if (found < this.#counts.get(name).looks) {
      this.problems.push(
        `${name}: not all pages were looked at, so that nothing is said of the site`,
      );
      return;
    }
    const expect = (good, where, what) => {
      if (!good) this.problems.push(`${name}: ${where}: ${what}`);
      return good;
    };
    conclude?.(facts, { folder: this.#folder, expect });
  }
}
