// The way to the site's worker.

import { addressOf } from "../search/scripts.js";

function savesData(): boolean {
  const { connection } = navigator as { connection?: { saveData?: boolean } };
  return connection?.saveData === true;
}

/**
 * Gives nothing where there is none and none may be: in a browser that refuses it, and, unless it is
 * `wanted`, where the reader saves data.
 */
export async function register(wanted = false): Promise<ServiceWorkerRegistration | undefined> {
  const scope = addressOf("");
  try {
    if (!wanted && savesData() && !(await navigator.serviceWorker.getRegistration(scope))) {
      return undefined;
    }
    return await navigator.serviceWorker.register(addressOf("sw.js"), {
      scope,
      updateViaCache: "none",
    });
  } catch {
    return undefined; // the site is complete without it
  }
}
