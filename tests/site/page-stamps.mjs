// Looks at pages that found nothing wrong, and need not be done again: of each there is a stamp in the
// user's cache, so that a fresh checkout knows them, too. Enter at new PageStamps().
//
// A stamp's name is a hash of all that is known before the page is opened: the check's name, source and
// settings, the walker's source, the packages and the browser, the view, the page's path and bytes. The
// stamp lists the other files of the site that the visit asked for, each with its hash, as ninja lists
// the headers that a compiler has read. A file that has changed, or was missing and is there, makes the
// stamp void. The stamp also holds what the check found out.

import { spawnSync } from "node:child_process";
import { readFileSync, statSync } from "node:fs";
import { join, resolve } from "node:path";

import { sourcesOf } from "../sources.mjs";
import { Stamps } from "../stamps.mjs";

const root = resolve(import.meta.dirname, "../..");
// What draws a page, beside its own fonts.
const browser = spawnSync("dpkg-query", ["--show", "chromium-headless-shell", "fonts-*"]).stdout;
const lock = readFileSync(join(root, "site/package-lock.json"));
const textOf = (path) => readFileSync(path);

export class PageStamps {
  #stamps = new Stamps("pages");
  #folder;
  #walker = sourcesOf(join(import.meta.dirname, "pages.mjs")).map(textOf);
  #checks = new Map(); // the hash of each check's source, by its name
  #files = new Map(); // the hash of each file of the site, by its path

  constructor(folder) {
    this.#folder = folder;
  }

  // The name of the stamp for a look of the check that `script` has, at `html` in a view.
  nameOf({ name, script, settings = [] }, view, path, html) {
    if (!this.#checks.has(name)) {
      const decide = [...sourcesOf(script), ...settings].map(textOf);
      this.#checks.set(name, Stamps.of(browser, lock, ...this.#walker, ...decide));
    }
    return Stamps.of(JSON.stringify([name, this.#checks.get(name), view, path]), html);
  }

  // What the check found out, as { facts }, where it needs not look again.
  find(stamp) {
    const text = this.#stamps.get(stamp);
    if (text === undefined) return undefined;
    try {
      const { files, facts } = JSON.parse(text);
      const same = Object.entries(files).every(([path, hash]) => this.#hashOf(path) === hash);
      return same ? { facts } : undefined;
    } catch {
      return undefined; // half of it, as a full disk leaves it
    }
  }

  put(stamp, paths, facts) {
    const files = Object.fromEntries(paths.map((path) => [path, this.#hashOf(path)]));
    this.#stamps.put(stamp, JSON.stringify({ files, facts }));
  }

  // "" where there is no such file.
  #hashOf(path) {
    const file = join(this.#folder, path);
    if (!this.#files.has(path)) {
      const isFile = statSync(file, { throwIfNoEntry: false })?.isFile();
      this.#files.set(path, isFile ? Stamps.of(readFileSync(file)) : "");
    }
    return this.#files.get(path);
  }
}
