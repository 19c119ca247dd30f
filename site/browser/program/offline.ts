/** The compiler on the reader's device: what was asked for works without a network from then on. */
import { ask } from "../client/offline/messages.js";
import { addressOf } from "../client/search/scripts.js";

/** Hands files, of which the addresses are given, to the site's worker, where there is one. */
export async function keepFiles(addresses: readonly string[]): Promise<void> {
  if (!("serviceWorker" in navigator)) return;
  const registration = await navigator.serviceWorker.getRegistration(addressOf(""));
  if (!registration?.active) return;
  for (const address of addresses) {
    const path = new URL(address, document.baseURI).href.slice(addressOf("").length);
    await ask(registration.active, "keep", path);
  }
}
