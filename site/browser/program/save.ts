/** Gives the reader a file that the page has made. */
import { make } from "../client/element.js";

export function save(content: Blob, name: string): void {
  const href = URL.createObjectURL(content);
  make("a", { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 60_000); // some browsers begin late
}
