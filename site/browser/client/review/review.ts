// The script of review.html: one question at a time, of those that are due.
//
// The first answer to a question counts; to look at the right one first counts as wrong. What comes
// after that is for the reader's own good.

import { Question } from "../quiz/question.js";
import { reachScrollers } from "../scrollers.js";
import { openedCards, type Card } from "./deck.js";

const due = document.querySelector<HTMLElement>("article.review > .due")!;
const deck = document.querySelector<HTMLElement>("article.review > .deck")!;

const byDay = (a: Card, b: Card): number => {
  const [first, second] = [a.review?.due ?? "9", b.review?.due ?? "9"]; // what is new comes last
  return first < second ? -1 : Number(first > second);
};

const dayInWords = (day: string): string =>
  new Date(`${day}T12:00`).toLocaleDateString(document.documentElement.lang || "en", {
    weekday: "long",
    day: "numeric",
    month: "long",
  });

function count(cards: readonly Card[]): string {
  if (cards.length === 0) {
    return "Nothing to review yet: questions come here once you have opened their lesson.";
  }
  const now = cards.filter((card) => card.isDue).length;
  if (now > 0) return `${now} due today, ${cards.length - now} later.`;
  const next = cards.map((card) => card.review?.due ?? "").sort()[0]!;
  return `Nothing is due today. The next question comes on ${dayInWords(next)}.`;
}

/** Lets `card` be answered once, and then offers the next. */
function deal(card: Card): void {
  const holder = document.createElement("div");
  holder.className = "dealt";
  holder.innerHTML = card.html; // the generator's own
  const answered = (right: boolean): void => {
    if (holder.querySelector("button.next-card")) return;
    card.judged(right);
    due.textContent = count(openedCards());
    holder.append(nextButton());
  };
  if (card.isExercise) {
    holder.querySelector("button.not-today")!.addEventListener("click", () => answered(false));
  } else {
    ask(holder, answered);
  }
  const source = document.createElement("p");
  source.className = "source";
  const link = document.createElement("a");
  link.href = card.href;
  link.textContent = card.lesson;
  source.append("From ", link);
  holder.prepend(source);
  deck.replaceChildren(holder);
  reachScrollers(holder);
}

function ask(holder: HTMLElement, answered: (right: boolean) => void): void {
  const form = holder.querySelector("form")!;
  new Question(form, false);
  form.addEventListener("judged", (event) => answered((event as CustomEvent<boolean>).detail));
  form
    .querySelector(":scope > .answer > summary")
    ?.addEventListener("click", () => answered(false));
}

function nextButton(): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "plain-button next-card";
  button.textContent = openedCards().some((card) => card.isDue) ? "Next question" : "Finish";
  button.addEventListener("click", () => {
    show();
    due.focus(); // the button is gone, and what was read begins anew
  });
  return button;
}

function show(): void {
  const cards = openedCards();
  due.textContent = count(cards);
  const next = cards.filter((card) => card.isDue).sort(byDay)[0];
  if (next) deal(next);
  else deck.replaceChildren();
}

show();
