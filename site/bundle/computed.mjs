// An esbuild plugin for modules that hold what is found out while bundling:
//
//   import widths from "computed:letter-widths";

import { compiledTemplates } from "./compiled-templates.mjs";
import { letterWidths } from "./letter-widths.mjs";
import { plotVocabulary } from "./plot-vocabulary.mjs";

// Each gives what is to be JSON, or the text of a module.
const makers = {
  "letter-widths": letterWidths,
  "plot-vocabulary": wordsOfPlots,
  templates: compiledTemplates,
};

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
      const made = await makers[args.path](site);
      if (typeof made === "string") return { contents: made, loader: "js" };
      return { contents: JSON.stringify(made), loader: "json" };
    });
  },
});
