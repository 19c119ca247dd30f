// Fetches the script of listings (listing.ts) where there are any. As a plain script, which a browser
// takes from the disk as well.

const address = (document.currentScript as HTMLScriptElement).dataset["listing"];

export function loadListing(): void {
  if (!address || !document.querySelector("pre")) return;
  const script = document.createElement("script");
  script.src = address;
  document.head.append(script);
}
