// The reader's text of a program, which the browser keeps until the lesson's takes its place again. The
// pages of a course share it: several lessons may show one program.

import { keys, recall, remember } from "./storage.js";

const keyOf = (file: string) =>
  keys.program(
    new URL(document.documentElement.dataset["root"] ?? "", location.href).pathname,
    file,
  );

export function keptText(file: string): string | undefined {
  return recall(keyOf(file)) ?? undefined;
}

export function keepText(file: string, text: string): void {
  remember(keyOf(file), text);
}

export function forgetText(file: string): void {
  remember(keyOf(file), null);
}
