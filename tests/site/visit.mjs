// A page that is opened in one view: which looks are to be done, and what they are told of it.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

export class Visit {
  requests = []; // Playwright's, since the page was empty
  root; // the site's address, while it is open
  #folder;
  #read = new Set();

  constructor(folder, view, path, html, looks) {
    this.#folder = folder;
    Object.assign(this, { view, path, html, looks });
  }

  // What a look is told, and how it complains: expect(good, what).
  toldWith(expect) {
    const { path, html, root, requests, read } = this;
    return { path, html, root, requests, read, expect };
  }

  // The text of a file of the site; nothing where there is none.
  read = (path) => {
    this.#read.add(path);
    const file = join(this.#folder, path);
    return existsSync(file) ? readFileSync(file, "utf8") : undefined;
  };

  // The files of the site that were asked for so far, also such as are not there.
  files = () => {
    const below = this.requests
      .map((request) => request.url().replace(/[?#].*$/, ""))
      .filter((address) => address.startsWith(this.root))
      .map((address) => decodeURIComponent(address.slice(this.root.length)) || "index.html");
    return [...new Set([...below, ...this.#read])].sort();
  };
}
