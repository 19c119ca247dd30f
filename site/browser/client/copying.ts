// Buttons that copy a listing, or what it printed. Where a browser lets no script copy, as on pages that
// no server gave, the text is selected instead, and the reader is told so.

const heads = "figcaption, .output-label";

function select(parts: readonly Element[]): void {
  for (const details of parts.map((part) => part.closest("details")))
    if (details) details.open = true;
  const range = document.createRange();
  range.setStartBefore(parts[0]!);
  range.setEndAfter(parts.at(-1)!);
  getSelection()?.removeAllRanges();
  getSelection()?.addRange(range);
}

async function copy(parts: readonly Element[]): Promise<string> {
  try {
    await navigator.clipboard.writeText(parts.map((part) => part.textContent).join(""));
    return "Copied";
  } catch {
    select(parts);
    return "Selected: copy it with the keyboard or the menu";
  }
}

/** In the line above, or over the corner of what has no such line. */
function place(pre: Element, ...added: readonly Element[]): void {
  const above = pre.previousElementSibling;
  if (above?.matches(heads)) above.append(...added);
  else {
    const corner = document.createElement("div");
    corner.className = "corner";
    corner.append(...added);
    pre.before(corner);
  }
}

function addButton(pre: Element): void {
  if (pre.previousElementSibling?.matches(".corner, :has(.copy)")) return;
  const isOutput = pre.parentElement?.matches("figure > .output");
  const parts = isOutput
    ? pre.parentElement!.querySelectorAll("samp")
    : pre.querySelectorAll("code");
  const button = document.createElement("button");
  const status = document.createElement("span");
  const file = pre.previousElementSibling?.querySelector(".file")?.textContent;
  const what = pre.matches(".code") ? (file ?? "this code") : "what was printed";
  button.type = "button";
  button.className = "copy";
  button.textContent = "Copy";
  button.ariaLabel = `Copy ${what}`;
  status.className = "copied";
  status.role = "status";
  button.addEventListener("click", () => {
    void copy([...parts]).then((said) => {
      status.textContent = said;
      setTimeout(() => (status.textContent = ""), 4000);
    });
  });
  place(pre, status, button);
}

/** For those in `root`, which is one itself or has them. */
export function addCopyButtons(root: Document | Element = document): void {
  const pres = ":is(figure.example, .demo) > .code, figure.example > .output > pre";
  if (root instanceof Element && root.matches(pres)) addButton(root);
  for (const pre of root.querySelectorAll(pres)) addButton(pre);
}
