// Every link inside the site leads to a file that is there, and every anchor to something on it. A
// link that leaves it is an address of the web, to the letter. A site that says where it is published
// says so on each page, and what it tells search engines and feed readers is there.

import { existsSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";

import { documents, folder, pages, testSite } from "./browser.mjs";

// What a page refers to, as whole addresses, and what can be referred to on it.
function references() {
  const attributes = ["href", "src", "srcset", "poster"];
  const found = attributes.flatMap((name) =>
    [...document.querySelectorAll(`[${name}]`)].map((element) => element.getAttribute(name)),
  );
  const invalid = found.filter((reference) => !URL.canParse(reference, document.baseURI));
  const addresses = found
    .filter((reference) => !invalid.includes(reference))
    .map((reference) => new URL(reference, document.baseURI).href);
  const outside = found.filter((reference) => /^[a-z][a-z0-9+.-]*:/i.test(reference));
  const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
  const canonical = document.querySelector('link[rel="canonical"]')?.getAttribute("href");
  const shared = document.querySelector('meta[property="og:url"]')?.content;
  return { addresses: [...new Set(addresses)], ids, invalid, outside, canonical, shared };
}

// What is wrong with an address that leaves the site, as it is written; "" for nothing.
function fault(address) {
  if (/[\s"<>\\^`{|}]|%(?![0-9a-f]{2})/i.test(address)) return "has a character to be escaped";
  if (/^(mailto|data):/.test(address)) return "";
  if (!/^https?:\/\//.test(address)) return "is not of the web";
  const { hostname, username, password } = new URL(address);
  if (username !== "" || password !== "") return "has a name or a password";
  const named = /^([a-z0-9-]+\.)+[a-z0-9-]+$|^localhost$|^\[[0-9a-f:]+\]$/.test(hostname);
  return named ? "" : "has no host that could be there";
}

// The addresses in an XML file of the site, or why it is none. Works in a page.
function addressesIn({ text, name }) {
  const xml = new DOMParser().parseFromString(text, "application/xml");
  const error = xml.querySelector("parsererror");
  if (error !== null) return { error: error.textContent };
  const entries = [...xml.querySelectorAll(name)];
  return { addresses: entries.map((entry) => entry.textContent) };
}

// As an address has what of a path is no plain character.
const addressOf = (path) =>
  encodeURIComponent(path)
    .replace(/[!'()*]/g, (sign) => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`)
    .replaceAll("%2F", "/");

// Of a site that is published at `root`, which is undefined for one that does not say.
async function checkPublished(visitor, found, root) {
  for (const [path, { canonical, shared }] of found) {
    const address = root && root + (path === "index.html" ? "" : addressOf(path));
    visitor.expect(canonical === address, path, `is ${address}, and calls itself ${canonical}`);
    visitor.expect(shared === address, path, `is ${address}, and is shared as ${shared}`);
  }
  const read = (name) => readFileSync(join(folder, name), "utf8");
  const files = ["sitemap.xml", "robots.txt", "feed.xml"].filter((name) =>
    existsSync(join(folder, name)),
  );
  if (root === undefined) {
    visitor.expect(files.length === 0, folder, `is published nowhere, and has ${files}`);
    return;
  }
  const known = [...found.keys()]
    .map((path) => root + (path === "index.html" ? "" : addressOf(path)))
    .sort();
  await visitor.visit("index.html", {}, async (page) => {
    const listed = await page.evaluate(addressesIn, { text: read("sitemap.xml"), name: "loc" });
    const all = `${listed.addresses?.toSorted()}` === `${known}`;
    visitor.expect(all, "sitemap.xml", listed.error ?? `lists ${listed.addresses}, not ${known}`);
    if (!files.includes("feed.xml")) return;
    const fed = await page.evaluate(addressesIn, { text: read("feed.xml"), name: "entry > id" });
    visitor.expect(fed.addresses?.length > 0, "feed.xml", fed.error ?? "has no entry");
    const lost = fed.addresses?.filter((address) => !known.includes(address)) ?? [];
    visitor.expect(lost.length === 0, "feed.xml", `tells of ${lost}, which is not there`);
  });
  const named = read("robots.txt").includes(`Sitemap: ${root}sitemap.xml\n`);
  visitor.expect(named, "robots.txt", "does not name the sitemap");
}

await testSite(async (visitor) => {
  const found = new Map();
  const before = (page) => page.setDefaultTimeout(60_000); // a document is long
  for (const path of [...pages, ...documents]) {
    await visitor.visit(path, { before }, async (page) => {
      found.set(path, await page.evaluate(references));
    });
  }
  const root = visitor.address("");
  for (const [path, { addresses, invalid, outside }] of found) {
    visitor.expect(invalid.length === 0, path, `these are no addresses: ${invalid}`);
    for (const address of outside) {
      visitor.expect(fault(address) === "", path, `${address} ${fault(address)}`);
    }
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
  await checkPublished(visitor, found, found.get("index.html").canonical);
});
