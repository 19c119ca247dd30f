// Loads what follows the reader (reading.ts). It is needed once there is something to read, and so stays
// out of the way of what the page needs to be shown.

/** Of site.js, while it runs; afterwards nobody knows. */
const address = document.currentScript?.dataset["reading"];

export function loadReading(): void {
  if (!address) return;
  const script = document.createElement("script");
  script.src = address;
  document.head.append(script);
}
