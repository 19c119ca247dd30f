/** What a reader takes away: a link to this very state, the state as C++, the curves as CSV. */
import { make } from "../markup/element.js";
import { menu, type Menu } from "../markup/menu.js";
import { cppState } from "../run/cpp-state.js";
import type { Run } from "../run/run.js";

export interface CopyMenu extends Menu {
  /** Says what was done, and shows the text where the browser lets no script copy. */
  readonly answer: HTMLElement;
}

export function copyMenu(run: Run, link: () => Promise<string | undefined>): CopyMenu {
  const answer = make("div", { class: "lab-copied", role: "status" });
  const copy = async (what: string, text: string): Promise<void> => {
    try {
      await navigator.clipboard.writeText(text);
      answer.replaceChildren(make("p", {}, `${what} copied.`));
    } catch {
      const area = make("textarea", { readonly: true, rows: 4, "aria-label": what }, text);
      answer.replaceChildren(make("p", {}, "Copy it from here:"), area);
      area.select();
    }
  };
  const curves = run.lab.plots.map(({ ylabel }, i) => {
    const save = (): void => download(`${ylabel}.csv`, run.samples[i]!.csv());
    return [`Download the curves of “${ylabel}” (CSV)`, save] as const;
  });
  const entries = new Map([
    [
      "Copy a link to this state",
      async () => {
        const address = await link();
        if (address === undefined) answer.replaceChildren(make("p", {}, "Too much for a link."));
        else await copy("Link", address);
      },
    ],
    ["Copy the state as C++", async () => copy("C++", cppState(run.simulation))],
    ...curves,
  ]);
  return { ...menu("copy", entries), answer };
}

function download(name: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  make("a", { href: address, download: name.replace(/[^\w .-]+/g, " ").trim() }).click();
  // The browser has taken the text by then.
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
