// A program that its reader edits, as tests find it in a page.

const patience = 240_000; // ms: a slow machine makes the headers ready once a reader

export const fallPage = "1-programs/1.1-fall.html";
export const wordsPage = "1-programs/1.2-words.html";
export const exercisePage = "1-programs/1.3-exercise.html";

export class Program {
  constructor(page, id) {
    this.page = page;
    this.root = page.locator(`#${id}, [data-program="snippets/${id}.cpp"]`);
  }

  // Opens the editor of the listing `id`, or of the snippet of this name, and agrees to what is fetched for it where that is asked.
  // Until it can be run.
  static async open(page, id = "example-fall") {
    const program = new Program(page, id);
    await program.button(/^(Edit and run|Solve it here|Go on with your version)/).click();
    const agree = program.button("Fetch the compiler");
    const said = program.status.filter({ hasText: /./ });
    await agree.or(said).first().waitFor();
    if (await agree.isVisible()) await agree.click();
    await program.says("Ready to run.");
    return program;
  }

  button(name) {
    return this.root.getByRole("button", { name, exact: typeof name === "string" });
  }

  get status() {
    return this.root.locator(".program-status");
  }

  get editor() {
    return this.root.getByRole("textbox", { name: /^Your text of/ });
  }

  says(text) {
    return this.status.filter({ hasText: text }).waitFor({ timeout: patience });
  }

  // What the reader's run printed; "" where nothing is shown.
  async printed() {
    return (await this.root.locator(".output.yours pre:visible samp").allTextContents()).join("");
  }

  text() {
    return this.editor.evaluate((content) =>
      [...content.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"),
    );
  }

  // Puts `text` in the place of all that stands there.
  async write(text) {
    await this.editor.focus();
    // A text typed over another would have its colours from the browser, which the policy refuses.
    for (const key of ["Control+a", "Delete"]) await this.page.keyboard.press(key);
    await this.page.keyboard.insertText(text);
  }

  async replace(from, to) {
    await this.write((await this.text()).replace(from, to));
  }

  // Until it has ended; gives what is said of that.
  async run(name = "Run") {
    await this.button(name).click();
    await this.says(/^(?!Compiling|Running|Ready|Fetching|Making)./);
    return this.status.innerText();
  }
}
