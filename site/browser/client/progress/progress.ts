// The script of progress.html: shows what this browser remembers of the course, and exports, imports
// and forgets it.

import { stateOf, words } from "../reading/readings.js";
import { showSigns } from "../reading/signs.js";
import { keys, recall, remember } from "../storage.js";
import { mostBytes, progressOf, textOf, Unreadable, type Progress } from "./file.js";
import { lessonsOf } from "./lessons.js";
import { merge } from "./merge.js";

const page = document.querySelector<HTMLElement>("article.progress")!;
const told = page.querySelector<HTMLElement>(".told")!;
const dialog = page.querySelector("dialog")!;
const picker = page.querySelector<HTMLInputElement>("input[type=file]")!;
const lessons = lessonsOf(page);
const last = keys.last(new URL(".", location.href).pathname);

function show(): void {
  for (const { row, kept, questions, right } of lessons) {
    const state = stateOf(kept.reading);
    const section = state === "started" && kept.reading?.heading;
    const text = section ? `${words[state]}, at ${section}` : words[state];
    row.querySelector(".lesson-state")!.textContent = text;
    row.querySelector(".right-answers")!.textContent = questions ? `${right} of ${questions}` : "–";
  }
  showSigns();
}

/** Whether this browser remembers anything at all. */
function remembers(): boolean {
  const trial = "mjcourse.trial";
  remember(trial, "1");
  const kept = recall(trial) === "1";
  remember(trial, null);
  return kept;
}

function exported(): Progress {
  const opened = lessons
    .map(({ href, kept }) => [href, kept] as const)
    .filter(([, kept]) => kept.reading ?? kept.texts ?? Object.keys(kept.answers).length > 0);
  const path = recall(last);
  const href = lessons.find((lesson) => lesson.path === path)?.href ?? "";
  return { last: href, lessons: Object.fromEntries(opened) };
}

function save(): void {
  const text = textOf(exported(), page.dataset["course"] ?? "");
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  link.download = "progress.json";
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  told.textContent = "Exported to progress.json.";
}

/** Says what was taken. */
function take(progress: Progress): string {
  const known = lessons.filter(({ href }) => Object.hasOwn(progress.lessons, href));
  if (known.length === 0) throw new Unreadable("it holds no lesson of this course");
  for (const lesson of known) lesson.keep(merge(lesson, progress.lessons[lesson.href]!));
  const lastRead = known.find(({ href }) => href === progress.last);
  if (lastRead && recall(last) === null) remember(last, lastRead.path);
  const strange = Object.keys(progress.lessons).length - known.length;
  const passedOver = strange > 0 ? ` ${strange} that this course has not were passed over.` : "";
  return `Imported: lessons ${known.length}.${passedOver}`;
}

async function load(file: File): Promise<void> {
  try {
    if (file.size > mostBytes) throw new Unreadable("it is larger than 16 MiB");
    told.textContent = take(progressOf(await file.text()));
    show();
  } catch (error) {
    const reason = error instanceof Unreadable ? error.message : "it cannot be read";
    told.textContent = `Nothing was imported from ${file.name}: ${reason}.`;
  }
  picker.value = ""; // so that the same file can be chosen again
}

function forget(): void {
  for (const lesson of lessons) lesson.keep({ answers: {} });
  remember(last, null);
  show();
  told.textContent = "Forgotten.";
}

page.querySelector(".export")!.addEventListener("click", save);
page.querySelector(".reset")!.addEventListener("click", () => {
  dialog.returnValue = "";
  dialog.showModal();
});
dialog.addEventListener("close", () => {
  if (dialog.returnValue === "forget") forget();
});
picker.addEventListener("change", () => {
  const file = picker.files?.[0];
  if (file) void load(file);
});
page.querySelector<HTMLElement>(".remembered")!.hidden = false;
show();
if (!remembers()) told.textContent = "This browser lets the site remember nothing, or has no room.";
