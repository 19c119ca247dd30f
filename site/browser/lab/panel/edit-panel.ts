/** The reader edits the MJCF: it is compiled as they type, and where it does not compile the last
 * model that did goes on. The editor itself is loaded when it is opened. */
import type { LoadError } from "../../engine/errors.js";
import type { ModelEditor } from "../editor/model-editor.js";
import { make } from "../markup/element.js";
import type { Run } from "../run/run.js";

export class EditPanel {
  readonly element: HTMLDetailsElement;
  readonly #run: Run;
  readonly #lesson: string;
  readonly #host = make("div", { class: "lab-editor" });
  readonly #status = make("p", { class: "lab-edit-status", role: "status" });
  readonly #rebuilt: () => void;
  #editor: Promise<ModelEditor> | undefined;

  /** `rebuilt` is called when there is another model, or another visualization of the same. */
  constructor(run: Run, tasks: readonly HTMLElement[], rebuilt: () => void) {
    this.#run = run;
    this.#lesson = run.mjcf;
    this.#rebuilt = rebuilt;
    const back = make("button", { type: "button", class: "lab-button" }, "The first text again");
    back.addEventListener("click", () => void this.replace(this.#lesson));
    const summary = make("summary", {}, "Edit the model");
    const parts = [summary, this.#host, this.#status, back, ...tasks];
    this.element = make("details", { class: "lab-edit" }, ...parts);
    this.element.addEventListener("toggle", () => {
      if (this.element.open) void this.#open();
    });
  }

  get edited(): boolean {
    return this.#run.mjcf !== this.#lesson;
  }

  /** Puts `text` in the editor's and the model's place. */
  async replace(text: string): Promise<void> {
    (await this.#editor)?.replace(text);
    await this.#compile(text);
  }

  async restoreLesson(): Promise<void> {
    if (this.edited || this.#editor) await this.replace(this.#lesson);
  }

  async #open(): Promise<void> {
    if (this.#editor) return;
    this.#status.textContent = "Loading the editor…";
    this.#editor = this.#load();
    try {
      await this.#editor;
      this.#status.textContent = "";
    } catch {
      this.#editor = undefined;
      this.#status.textContent =
        "The editor could not be loaded. Check the connection, then open this again.";
    }
  }

  async #load(): Promise<ModelEditor> {
    const { openModelEditor } = await import("../editor/model-editor.js");
    return openModelEditor(this.#host, {
      text: this.#run.mjcf,
      label: `MJCF of ${this.#run.lab.model.name}`,
      file: this.#run.lab.model.name,
      onChange: (text) => void this.#compile(text),
    });
  }

  async #compile(text: string): Promise<void> {
    const { visualization } = this.#run;
    const error = this.#run.recompile(text);
    this.#status.textContent = error === undefined ? "" : sentence(error);
    this.#status.classList.toggle("wrong", error !== undefined);
    if (this.#run.visualization !== visualization) this.#rebuilt();
    (await this.#editor)?.showError(error);
  }
}

function sentence({ line, message, cure }: LoadError): string {
  const place = line > 0 ? `Line ${line}: ` : "";
  return `${place}${message}${cure === "" ? "" : ` (${cure})`}`;
}
