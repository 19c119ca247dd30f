/** The reader guesses, then the run answers: guess and measured value stand side by side. */
import { isNear } from "../../client/quiz/near.js";
import { parseNumber } from "../../client/quiz/number.js";
import type { Predict as PredictDescription } from "../lab-module.js";
import { fromHtml, make, newId } from "../markup/element.js";
import { fixed } from "../run/fixed.js";

export class Predict {
  readonly element: HTMLElement;
  readonly #description: PredictDescription;
  readonly #field: HTMLInputElement;
  readonly #button = make("button", { class: "lab-button" }, "Guess, then run");
  readonly #answer = make("div", { role: "status" });
  #guess = NaN;

  /** `start` begins the run that answers; its end is told to answer(). */
  constructor(description: PredictDescription, start: () => void) {
    this.#description = description;
    const id = newId();
    const attributes = { type: "text", inputmode: "decimal", autocomplete: "off" };
    this.#field = make("input", { ...attributes, "aria-labelledby": id });
    const unit = make("span", { class: "unit" }, description.unit);
    const form = make("form", {}, this.#field, unit, this.#button);
    const question = make("div", { id }, fromHtml(description.question));
    this.element = make("div", { class: "lab-predict" }, question, form, this.#answer);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const guess = parseNumber(this.#field.value);
      if (guess === undefined) {
        this.#say("That is not a number: write it as 30, 3e1 or 0.5.");
        return;
      }
      this.#guess = guess;
      this.#say(`Running ${description.seconds} s…`);
      start();
    });
  }

  answer(measured: number): void {
    const { tolerance, digits, unit, explanation } = this.#description;
    const right = isNear(this.#guess, measured, tolerance);
    const rows = [
      ["Your guess", this.#field.value.trim()],
      ["Measured", fixed(measured, digits)],
    ] as const;
    const list = make("dl", { class: "lab-compare" });
    for (const [term, value] of rows) {
      list.append(make("dt", {}, term), make("dd", {}, unit === "" ? value : `${value} ${unit}`));
    }
    const verdict = right ? "Right." : "Not quite.";
    const words = make("p", { class: `lab-verdict ${right ? "good" : "off"}` }, verdict);
    this.#answer.replaceChildren(list, words, fromHtml(explanation));
    this.#button.textContent = "Guess again";
  }

  /** The run was broken off. */
  forget(): void {
    this.#answer.replaceChildren();
    this.#button.textContent = "Guess, then run";
  }

  #say(text: string): void {
    this.#answer.replaceChildren(make("p", {}, text));
  }
}
