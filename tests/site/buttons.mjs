// The buttons of a page, pressed.

// Presses all buttons that are seen, and tells of each whether anything of the page changed. A lab is not
// played.
export async function press() {
  const seen = (button) => button.checkVisibility() && !button.matches(".lab-play, :disabled");
  const told = [];
  for (const button of [...document.querySelectorAll("button, summary")].filter(seen)) {
    let changed = false;
    const observer = new MutationObserver(() => (changed = true));
    observer.observe(document, {
      subtree: true,
      attributes: true,
      childList: true,
      characterData: true,
    });
    button.click();
    for (let i = 0; i < 20 && !changed; ++i) await new Promise((go) => setTimeout(go, 50));
    observer.disconnect();
    told.push(`${button.localName}.${button.className} ${changed ? "acts" : "does nothing"}`);
    for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
  }
  return told.join("\n");
}
