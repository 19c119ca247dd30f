// What a reader types between the key that opens the search and the search that it opens.

/** Takes every key that writes, until `end` is called, which gives the text. */
export function takeTyped(): { readonly end: () => string } {
  let text = "";
  const listening = new AbortController();
  const take = (event: KeyboardEvent): void => {
    const { key } = event;
    const commands = event.metaKey || (event.ctrlKey && !event.getModifierState("AltGraph"));
    if (event.isComposing || commands) return;
    if (key === "Backspace") text = text.slice(0, -1);
    else if (/^.$/u.test(key)) text += key;
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  // Ahead of the page's own single keys.
  addEventListener("keydown", take, { capture: true, signal: listening.signal });
  return {
    end: () => {
      listening.abort();
      return text;
    },
  };
}
