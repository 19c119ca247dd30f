/** The keys of a lab, which act while the focus is in it. What a focused field does with a key by
 * itself stays so: Space presses a button, the arrows move a slider. */

export interface Shortcut {
  /** As KeyboardEvent.key has them; "Shift+" for what needs it said. */
  readonly keys: readonly string[];
  /** For the list of keys. */
  readonly shown: string;
  readonly what: string;
  readonly act: () => void;
}

/** `inView` act only while the view itself has the focus. */
export function listenToKeys(
  lab: HTMLElement,
  view: HTMLElement,
  everywhere: readonly Shortcut[],
  inView: readonly Shortcut[],
): void {
  lab.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const { target } = event;
    if (!(target instanceof Element) || isOwn(target, event.key)) return;
    const open = target === view ? [...inView, ...everywhere] : everywhere;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const held = event.shiftKey ? `Shift+${key}` : key;
    const found = open.find(({ keys }) => keys.includes(held) || keys.includes(key));
    if (found === undefined) return;
    event.preventDefault();
    found.act();
  });
}

const pressed = "button, summary, a, [type=checkbox], select";
const typed = "input:not([type=range], [type=checkbox]), textarea, select, sim-lab .lab-editor";
const slid = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End"];

/** Whether the element itself does something with the key. */
function isOwn(element: Element, key: string): boolean {
  if (element.matches(typed) || element.closest(typed) !== null) return true;
  if (key === " " || key === "Enter") return element.matches(pressed);
  return slid.includes(key) && element.matches("[type=range]");
}
