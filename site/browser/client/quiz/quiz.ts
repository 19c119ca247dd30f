// Knowledge checks that answer back. The forms are there without this; here they get their buttons.

import { startParts } from "../parts.js";
import { Question } from "./question.js";

function upgrade(quiz: Element): void {
  const forms = quiz.querySelectorAll<HTMLFormElement>("form.question");
  const questions = [...forms].map((form) => new Question(form));
  const reset = document.createElement("button");
  reset.type = "button";
  reset.className = "plain-button forget";
  reset.textContent = "Forget my answers";
  reset.addEventListener("click", () => {
    for (const question of questions) question.forget();
  });
  quiz.append(reset);
}

/** Those in `root`, which may be one itself; none of the document that is made to be printed. */
export function upgradeQuizzes(root: Document | Element = document): void {
  const own = root instanceof Element && root.matches(".quiz[id]") ? [root] : [];
  const quizzes = [...own, ...root.querySelectorAll(".quiz[id]:not(article.printed *)")];
  startParts(...quizzes.map((quiz) => () => upgrade(quiz)));
}
