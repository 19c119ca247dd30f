// Asks for the fonts of a page, which a browser finds only once it lays out what is set in them. By
// script, since a page that was opened from the disk may not ask ahead, and complains.

/** Of site.js, while it runs; afterwards nobody knows. */
const addresses = document.currentScript?.dataset["fonts"];

export function askForFonts(): void {
  if (!addresses || location.protocol === "file:") return;
  for (const address of addresses.split(" ")) {
    const link = document.createElement("link");
    link.rel = "preload";
    link.as = "font";
    link.type = "font/woff2";
    link.crossOrigin = "anonymous";
    link.href = address;
    document.head.append(link);
  }
}
