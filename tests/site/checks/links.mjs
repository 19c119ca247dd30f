// Every link inside the site leads to a file that is there, and every anchor to something on it. A
// link that leaves it is an address of the web, to the letter. A site that says where it is published
// says so on each page, and what it tells search engines and feed readers is there.

import { existsSync, statSync } from "node:fs";
import { join } from "node:path";

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

// The addresses in an XML text, in the elements of that name, or why it is none. Works in a page.
function addressesIn({ text, name }) {
  const xml = new DOMParser().parseFromString(text, "application/xml");
  const error = xml.querySelector("parsererror");
  if (error !== null) return { error: error.textContent };
  const entries = [...xml.querySelectorAll(name)];
  return { addresses: entries.map((entry) => entry.textContent) };
}

// What the site tells search engines and feed readers, where it is published.
async function told(page, read) {
  const [sitemap, feed] = ["sitemap.xml", "feed.xml"].map(read);
  const listed = (text, name) => text && page.evaluate(addressesIn, { text, name });
  return {
    sitemap: await listed(sitemap, "loc"),
    feed: await listed(feed, "entry > id"),
    robots: read("robots.txt"),
  };
}

// Gives the links into the site, below its root, and what conclude() holds them against.
async function light(page, { path, expect, root, read }) {
  const { addresses, invalid, outside, ...facts } = await page.evaluate(references);
  expect(invalid.length === 0, `these are no addresses: ${invalid}`);
  for (const address of outside) expect(fault(address) === "", `${address} ${fault(address)}`);
  const here = addresses.filter((address) => address.startsWith("http://127."));
  const lost = here.filter((address) => !address.startsWith(root));
  expect(lost.length === 0, `links to ${lost}, above the site`);
  const links = here.map((address) => address.replace(root, ""));
  return { ...facts, links, ...(path === "index.html" && (await told(page, read))) };
}

export const kinds = ["page", "document"];
export const looks = { light };

// Whether each link leads to a file and, behind a #, to an id of its page.
function followLinks(found, { expect, folder }) {
  const ids = new Map([...found].map(([path, facts]) => [path, new Set(facts.ids)]));
  for (const [path, { links }] of found) {
    for (const link of links) {
      const { pathname, hash } = new URL(link, "http://site/");
      const target = decodeURIComponent(pathname.slice(1));
      const file = join(folder, target);
      const there = existsSync(file) && statSync(file).isFile();
      if (!expect(there, path, `a link to ${target}, which is not there`)) continue;
      const id = decodeURIComponent(hash.slice(1));
      const reached = id === "" || ids.get(target)?.has(id);
      expect(reached, path, `a link to ${target}${hash}, where nothing has this id`);
    }
  }
}

// As an address has what of a path is no plain character.
const addressOf = (path) =>
  encodeURIComponent(path)
    .replace(/[!'()*]/g, (sign) => `%${sign.charCodeAt(0).toString(16).toUpperCase()}`)
    .replaceAll("%2F", "/");

// Of a site that is published at `root`, which is undefined for one that does not say.
function checkPublished(found, root, { expect }) {
  const { sitemap, feed, robots } = found.get("index.html");
  const published = (path) => root && root + (path === "index.html" ? "" : addressOf(path));
  for (const [path, { canonical, shared }] of found) {
    const address = published(path);
    expect(canonical === address, path, `is ${address}, and calls itself ${canonical}`);
    expect(shared === address, path, `is ${address}, and is shared as ${shared}`);
  }
  if (root === undefined) {
    const none = sitemap === undefined && feed === undefined && robots === undefined;
    expect(none, "the site", "is published nowhere, and has a sitemap, a feed or robots.txt");
    return;
  }
  const known = [...found.keys()].map(published).sort();
  const all = `${sitemap?.addresses?.toSorted()}` === `${known}`;
  expect(all, "sitemap.xml", sitemap?.error ?? `lists ${sitemap?.addresses}, not ${known}`);
  const named = robots?.includes(`Sitemap: ${root}sitemap.xml\n`);
  expect(named, "robots.txt", "does not name the sitemap");
  if (feed === undefined) return;
  expect(feed.addresses?.length > 0, "feed.xml", feed.error ?? "has no entry");
  const strange = feed.addresses?.filter((address) => !known.includes(address)) ?? [];
  expect(strange.length === 0, "feed.xml", `tells of ${strange}, which is not there`);
}

export function conclude({ light: found }, site) {
  followLinks(found, site);
  checkPublished(found, found.get("index.html").canonical, site);
}
