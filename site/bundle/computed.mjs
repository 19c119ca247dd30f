// An esbuild plugin for modules that hold what is found out while bundling:
//
//   import widths from "computed:letter-widths";

import { letterWidths } from "./letter-widths.mjs";
import { plotVocabulary } from "./plot-vocabulary.mjs";

const makers = { "letter-widths": letterWidths, "plot-vocabulary": wordsOfPlots };

// What they mean is for editors.
async function wordsOfPlots(site) {
  const { elsewhere, states } = await plotVocabulary(site);
  return { elsewhere, states: states.map((state) => ({ ...state, meanings: undefined })) };
}

export const computed = (site) => ({
  name: "computed",
  setup(hooks) {
    hooks.onResolve({ filter: /^computed:/ }, (args) => {
      return { path: args.path.slice("computed:".length), namespace: "computed" };
    });
    hooks.onLoad({ filter: /.*/, namespace: "computed" }, async (args) => {
      return { contents: JSON.stringify(await makers[args.path](site)), loader: "json" };
    });
  },
});
