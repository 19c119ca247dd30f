/** What a reader takes away: a link to this very state, the state as C++, the curves as CSV. */
import { make } from "../markup/element.js";
import { menu, type Menu } from "../markup/menu.js";
import { cppState } from "../run/cpp-state.js";
import type { Run } from "../run/run.js";

export interface CopyMenu extends Menu {
  /** Says what was done, and shows the text where the browser lets no script copy. */
  readonly answer: HTMLElement;
}

/** `lab` has `data-compiler` where the site can run what its reader writes. */
export function copyMenu(
  lab: HTMLElement,
  run: Run,
  link: () => Promise<string | undefined>,
): CopyMenu {
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
  const openProgram = [
    "Open the state as a program",
    async () => {
      const { showStateProgram } = await import("../../program/state-program.js");
      const { time, files, lab: description } = run;
      const code = cppState(run.simulation);
      const state = { title: description.title, time, code, model: description.model.name, files };
      showStateProgram(lab, state);
    },
  ] as const;
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
    ...("compiler" in lab.dataset ? [openProgram] : []),
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
