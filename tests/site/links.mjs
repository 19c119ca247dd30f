// Every link inside the site leads to a file that is there, and every anchor to something on it.

import { existsSync, statSync } from "node:fs";
import { join } from "node:path";

import { folder, pages, testSite } from "./browser.mjs";

// What a page refers to, as whole addresses, and what can be referred to on it.
function references() {
  const attributes = ["href", "src", "srcset", "poster"];
  const found = attributes.flatMap((name) =>
    [...document.querySelectorAll(`[${name}]`)].map((element) => element.getAttribute(name)),
  );
  const addresses = found.map((reference) => new URL(reference, document.baseURI).href);
  const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
  return { addresses: [...new Set(addresses)], ids };
}

await testSite(async (visitor) => {
  const found = new Map();
  for (const path of pages) {
    await visitor.visit(path, {}, async (page) => {
      found.set(path, await page.evaluate(references));
    });
  }
  const root = visitor.address("");
  for (const [path, { addresses }] of found) {
    for (const address of addresses.filter((address) => address.startsWith("http://127."))) {
      const { pathname, hash } = new URL(address);
      const target = decodeURIComponent(pathname.slice(new URL(root).pathname.length));
      const file = join(folder, target);
      const there = address.startsWith(root) && existsSync(file) && statSync(file).isFile();
      if (!visitor.expect(there, path, `a link to ${target}, which is not there`)) continue;
      const id = decodeURIComponent(hash.slice(1));
      const reached = id === "" || found.get(target)?.ids.includes(id);
      visitor.expect(reached, path, `a link to ${target}${hash}, where nothing has this id`);
    }
  }
});
