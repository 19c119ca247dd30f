/** The solution of an exercise beside what the reader wrote. */
import { cpp } from "@codemirror/lang-cpp";
import { make } from "../client/element.js";

export class Solution {
  readonly element = make("div", { class: "solution-beside", hidden: "" });
  readonly #address: string;
  readonly #region: string;
  readonly #host = make("div", { class: "program-editor" });

  /** `address` is that of the program with the solution in `region`. */
  constructor(address: string, region: string) {
    this.#address = address;
    this.#region = region;
    const label = "What you wrote (−), and the solution (+)";
    this.element.append(make("p", { class: "output-label" }, label), this.#host);
  }

  hide(): void {
    this.element.hidden = true;
  }

  /** Rejects where it cannot be loaded. */
  async show(text: string): Promise<void> {
    const [response, { compareTexts }] = await Promise.all([
      fetch(this.#address),
      import("../editor/comparison.js"),
    ]);
    if (!response.ok) throw new Error(`${response.status} for ${this.#address}`);
    const solution = await response.text();
    const [own, other] = [inRegion(text, this.#region), inRegion(solution, this.#region)];
    const whole = own === undefined || other === undefined;
    this.element.hidden = false;
    compareTexts(
      this.#host,
      whole ? [text, solution] : [own, other],
      "What you wrote and the lesson’s solution",
      cpp(),
    );
  }
}

/** What stands between the marks of the region; undefined where one is gone. */
function inRegion(text: string, region: string): string | undefined {
  const lines = text.split("\n");
  const isMark = (word: string) => (line: string) => line.trim() === `// #${word}`;
  const begin = lines.findIndex(isMark(`region ${region}`));
  const length = lines.slice(begin + 1).findIndex(isMark("endregion"));
  if (begin < 0 || length < 0) return undefined;
  return lines.slice(begin + 1, begin + 1 + length).join("\n");
}
