// Pictures keep their addresses when they are drawn anew, and a browser keeps what it has of an
// address; so a new picture gets its hash behind its address.

import { decoded } from "../client/decoded.js";

const attributes = ["src", "srcset", "poster"];

// What was renewed once is, in a part that is put in place later, the old one again.
const renewals = new Map<string, string>();

let known: Readonly<Record<string, string>> | undefined;

export function renewPictures(hashes: Readonly<Record<string, string>>): void {
  const before = known;
  known = hashes;
  if (!before) return;
  for (const element of document.querySelectorAll("img, source, video")) {
    for (const name of attributes) {
      const value = element.getAttribute(name);
      if (value === null) continue;
      const [address] = value.split("?");
      const path = decoded(new URL(address!, location.href).pathname.slice(1));
      const hash = hashes[path];
      const renewed = renewals.get(path);
      if (hash === undefined || (hash === before[path] && renewed === undefined)) continue;
      if (value !== `${address}?${hash}`) element.setAttribute(name, `${address}?${hash}`);
      renewals.set(path, hash);
    }
  }
}
