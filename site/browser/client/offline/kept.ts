// The script of offline.html: lists what this device keeps of the course, keeps all of it, and forgets
// it. The worker leads here as well, from a page that is not kept when there is no network.

import { decoded } from "../decoded.js";
import { make } from "../element.js";
import { nameOf } from "../search/pages.js";
import { addressOf, run } from "../search/scripts.js";
import { ask, type Inventory } from "./messages.js";
import { register } from "./register.js";
import { keepFiles, keepWhole, missing, missingAsked, sizeOf } from "./whole.js";

const article = document.querySelector<HTMLElement>("article.kept")!;
const told = article.querySelector<HTMLElement>(".told")!;
const bar = article.querySelector("progress")!;
const button = (name: string) => article.querySelector<HTMLButtonElement>(`button.${name}`)!;

/** Those that the search knows, in the order of the course. */
async function listPages(kept: readonly string[]): Promise<void> {
  await run("search.js");
  await run(window.mjcourse!.index);
  const known = new Set(kept);
  const pages = window.mjcourse!.pages!.filter(({ href }) => known.has(decoded(href)));
  const items = pages.map((page) => make("li", {}, make("a", { href: page.href }, nameOf(page))));
  const section = article.querySelector<HTMLElement>(".kept-pages")!;
  section.querySelector("ul")!.replaceChildren(...items);
  section.hidden = items.length === 0;
}

async function show(worker: ServiceWorker): Promise<void> {
  const inventory = await ask(worker, "inventory");
  const open = missing(inventory);
  const compiler = missingAsked(inventory);
  const megabytes = (paths: readonly string[]) =>
    `${Math.max(sizeOf(inventory, paths) / 1e6, 0.1).toFixed(1)} MB`;
  button("keep-all").textContent = `Keep the whole course on this device (${megabytes(open)})`;
  button("keep-all").hidden = open.length === 0;
  button("keep-compiler").textContent =
    `Keep the C++ compiler, which runs the programs (${megabytes(compiler)})`;
  button("keep-compiler").hidden = compiler.length === 0;
  button("forget-kept").hidden = false;
  if (open.length === 0) told.textContent = "The whole course is kept on this device.";
  await listPages(inventory.kept);
}

/** As keepWhole() of `what`, in front of the reader. */
async function keep(
  worker: ServiceWorker,
  what: string,
  work: (signal: AbortSignal, tell: (share: number) => void) => Promise<string>,
): Promise<void> {
  const stop = new AbortController();
  const cancel = button("cancel");
  cancel.onclick = () => stop.abort();
  bar.value = 0;
  bar.hidden = cancel.hidden = false;
  for (const name of ["keep-all", "keep-compiler", "forget-kept"]) button(name).hidden = true;
  told.textContent = `Keeping ${what}.`;
  cancel.focus();
  void navigator.storage.persist(); // else the browser may forget it when it wants room
  const reason = await work(stop.signal, (share) => {
    bar.value = share;
  });
  bar.hidden = cancel.hidden = true;
  told.textContent = "";
  if (reason !== "") told.textContent = `Not all is kept: ${reason}. What has come stays.`;
  await show(worker);
}

const keepAll = (worker: ServiceWorker) =>
  keep(worker, "the whole course", (signal, tell) => keepWhole(worker, signal, tell));

const keepCompiler = (worker: ServiceWorker) =>
  keep(worker, "the C++ compiler", async (signal, tell) => {
    const inventory: Inventory = await ask(worker, "inventory");
    return keepFiles(worker, inventory, missingAsked(inventory), signal, tell);
  });

async function forget(worker: ServiceWorker): Promise<void> {
  await ask(worker, "forget");
  told.textContent = "Forgotten, but for what every page needs.";
  await show(worker);
}

/** The way to the page that was asked for; it is taken at once when the network is back. */
function showWanted(page: string): void {
  const address = new URL(page, addressOf("")).href;
  if (!address.startsWith(addressOf(""))) return;
  const notice = article.querySelector<HTMLElement>(".not-kept")!;
  const again = make("a", { href: address }, "Try again");
  notice.replaceChildren(`The network cannot be reached, and ${page} is not kept here. `, again);
  notice.hidden = false;
  addEventListener("online", () => location.replace(address));
}

async function beginNow(): Promise<void> {
  if (await register(true)) location.reload();
  else told.textContent = "This browser refuses to keep anything.";
}

/** Nothing is kept, as the reader saves data, or the browser refuses it. */
function offer(): void {
  told.textContent = "Nothing is kept, as this browser saves data, or keeps nothing at all.";
  button("begin").hidden = false;
  button("begin").onclick = () => void beginNow();
}

async function begin(): Promise<void> {
  const page = new URLSearchParams(location.search).get("page");
  if (page !== null) showWanted(page);
  if (!document.querySelector("script[data-offline]") || !("serviceWorker" in navigator)) {
    told.textContent =
      "Nothing is kept here: that needs a course that comes from the web, over https.";
    return;
  }
  if (!(await register())) {
    offer();
    return;
  }
  told.textContent = "Getting what every page needs …";
  const worker = (await navigator.serviceWorker.ready).active!;
  told.textContent = "";
  button("keep-all").onclick = () => void keepAll(worker);
  button("keep-compiler").onclick = () => void keepCompiler(worker);
  button("forget-kept").onclick = () => void forget(worker);
  await show(worker);
}

void begin();
