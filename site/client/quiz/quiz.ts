// Knowledge checks that answer back. The forms are there without this; here they get their buttons.

import { Question } from "./question.js";

function upgrade(quiz: Element): void {
  const forms = quiz.querySelectorAll<HTMLFormElement>("form.question");
  const questions = [...forms].map((form) => new Question(form));
  const reset = document.createElement("button");
  reset.type = "button";
  reset.className = "forget";
  reset.textContent = "Forget my answers";
  reset.addEventListener("click", () => {
    for (const question of questions) question.forget();
  });
  quiz.append(reset);
}

export function upgradeQuizzes(): void {
  for (const quiz of document.querySelectorAll(".quiz")) upgrade(quiz);
}
