// What the tests of the reader's own pages share.

// Fills a question's form with `given`: a number, or letters, in order where order is asked.
export async function answer(question, given) {
  const kind = await question.getAttribute("data-kind");
  if (kind === "numeric") await question.getByRole("textbox").fill(given);
  else if (kind === "order") await sort(question, given.split(" "));
  else {
    for (const box of await question.locator("input[value]").all()) {
      const wanted = given.split(" ").includes(await box.getAttribute("value"));
      if (kind === "multi") await box.setChecked(wanted);
      else if (wanted) await box.check();
    }
  }
  await question.getByRole("button", { name: "Check" }).click();
}

export const answerRightly = async (question) =>
  answer(question, await question.getAttribute("data-key"));

async function sort(question, letters) {
  for (const letter of letters.toReversed()) {
    const up = question.locator(`li[data-letter="${letter}"]`).getByRole("button", { name: "up" });
    while ((await up.getAttribute("aria-disabled")) === "false") await up.click();
  }
}
