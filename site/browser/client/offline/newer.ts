// Says that a newer version of the course has come. It waits until the reader wants it; then every open
// page of the course is loaded anew, since an old page must not ask the new version for its files.

import { make } from "../element.js";
import { ask } from "./messages.js";

const bar = make("div", { class: "newer", role: "status" });

function show(waiting: ServiceWorker): void {
  const button = make("button", { type: "button", class: "plain-button" }, "Show it");
  button.addEventListener("click", () => void ask(waiting, "take over"));
  bar.replaceChildren("A newer version of this course is there. ", button);
}

/** `worker` is being installed; afterwards it waits, unless it is the first. */
function follow(worker: ServiceWorker): void {
  worker.addEventListener("statechange", () => {
    if (worker.state === "installed" && navigator.serviceWorker.controller) show(worker);
  });
}

export function announceNewer(registration: ServiceWorkerRegistration): void {
  document.body.append(bar); // empty at first, so that what comes is read out
  const { installing, waiting } = registration;
  if (waiting && navigator.serviceWorker.controller) show(waiting);
  if (installing) follow(installing);
  registration.addEventListener("updatefound", () => {
    if (registration.installing) follow(registration.installing);
  });
  let hadWorker = navigator.serviceWorker.controller !== null;
  navigator.serviceWorker.addEventListener("controllerchange", () => {
    if (hadWorker) location.reload();
    hadWorker = true;
  });
}
