/**
 * A lesson's program that its reader edits and runs in the page: enter at openProgram(), which
 * client/programs.ts calls once the reader has asked for it. However many programs a page has, there is
 * one compiler (compiler.ts).
 */
import { keptText } from "../client/program-text.js";
import { wear } from "../lab/page/stylesheet.js";
import { Compiler } from "./compiler.js";
import { Folder } from "./folder.js";
import { Panel } from "./panel.js";
import { decodeText } from "./program-link.js";
import { madeFolder } from "./state-program.js";

/** Of each program of the page, by its file. Several listings may show parts of one. */
const panels = new Map<string, Panel>();

/** `figure` is the listing. `linked` is the text that a link has brought. Rejects where something cannot
 * be loaded. */
export async function openProgram(figure: HTMLElement, linked?: string): Promise<void> {
  const { dataset } = figure;
  const address = (name: string): string => new URL(dataset[name]!, document.baseURI).href;
  const [folder, text] = await Promise.all([
    madeFolder(figure) ?? fetchFolder(figure),
    linked === undefined ? undefined : decodeText(linked),
    wear(address("style")),
  ]);
  const file = dataset["program"]!;
  panels.get(file)?.close();
  const compiler = Compiler.of({
    worker: address("worker"),
    llvm: address("llvm"),
    pack: address("pack"),
    engine: address("engine"),
    wasm: address("wasm"),
  });
  const panel = new Panel(figure, file, folder, compiler);
  panels.set(file, panel);
  panel.open(text, linked === undefined ? remarkOn(file, folder) : remarkOnLink(text));
}

function fetchFolder(figure: HTMLElement): Promise<Folder> {
  const { href } = figure.querySelector<HTMLAnchorElement>("a.zip")!;
  return Folder.fetch(href, figure.dataset["region"] === undefined ? "hidden" : "shown");
}

/** What the reader is to know of the text that opens. */
function remarkOn(file: string, folder: Folder): string {
  const own = keptText(file);
  if (folder.isOfLesson || own === undefined || own === folder.text) return "";
  return "This is what you wrote before; “Reset to the lab’s” brings the state that the lab has now.";
}

function remarkOnLink(text: string | undefined): string {
  return text === undefined
    ? "The text of the link could not be read: it may have been cut off."
    : "This is the text that the link brought.";
}
