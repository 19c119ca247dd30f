// Loads what keeps pages on the reader's device (offline.ts), once the page has all that it shows. A
// preview names no such script, and a site that was opened from the disk can have no worker.

/** Of site.js, while it runs; afterwards nobody knows. */
const address = document.currentScript?.dataset["offline"];

export function loadOffline(): void {
  if (!address || !isSecureContext || !("serviceWorker" in navigator)) return;
  if (location.protocol === "file:") return;
  addEventListener("load", () => {
    const script = document.createElement("script");
    script.src = address;
    document.head.append(script);
  });
}
