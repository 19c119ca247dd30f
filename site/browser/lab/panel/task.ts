/** A number that the reader finds for the model as edited; the compiled model judges it. */
import { parseNumber } from "../../client/quiz/number.js";
import type { Task } from "../lab-module.js";
import { fromHtml, make, newId } from "../markup/element.js";
import type { Run } from "../run/run.js";

export function taskForm(run: Run, task: Task, index: number): HTMLElement {
  const id = newId();
  const attributes = { type: "text", inputmode: "decimal", autocomplete: "off" };
  const field = make("input", { ...attributes, "aria-labelledby": id });
  const verdict = make("span", { class: "lab-verdict", role: "status" });
  const unit = make("span", { class: "unit" }, task.unit);
  const check = make("button", { class: "lab-button" }, "Check");
  const form = make("form", {}, field, unit, check, verdict);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    verdict.textContent = judge(run, index, field.value);
    verdict.className = `lab-verdict ${verdict.textContent === words.right ? "good" : "off"}`;
  });
  field.addEventListener("input", () => (verdict.textContent = ""));
  return make("div", { class: "lab-task" }, make("div", { id }, fromHtml(task.question)), form);
}

const words = {
  right: "Right.",
  wrong: "Not yet: try again.",
  unclear: "That is not a number: write it as 30, 3e1 or 0.5.",
  early: "First reach the goal, then answer.",
  silent: "The model as it is gives no such number.",
} as const;

function judge(run: Run, index: number, text: string): string {
  const given = parseNumber(text);
  if (given === undefined) return words.unclear;
  if (!run.tasksOpen) return words.early;
  const right = run.judgeTask(index, given);
  if (right === undefined) return words.silent;
  return right ? words.right : words.wrong;
}
