// 404.html, which a host shows at any address where there is no page: styled and with links that
// work from every depth of a site, and with a way home in words where there is no JavaScript.

import { violations } from "./axe.mjs";
import { testSite } from "./browser.mjs";
import { mostShifted, shiftOf } from "./shift.mjs";

const wrong = [
  "1.2-generalised-coordinates.html",
  "1-state/generalised-coordinates.html",
  "1-state/no/such/1.2-Generalised%20coordinates",
];

// Whether the page has the site's own stylesheet.
const isStyled = () =>
  getComputedStyle(document.documentElement).getPropertyValue("--paper") !== "";

async function answersOf(page) {
  const links = await page.locator("a[href]").evaluateAll((all) => all.map(({ href }) => href));
  const pages = [...new Set(links.map((link) => link.split("#")[0]))];
  return Promise.all(pages.map(async (link) => [link, (await page.request.get(link)).status()]));
}

// Only what the page's own address and its guesses at the root have to do with is expected.
function forgive(page) {
  page.removeAllListeners("response");
  page.removeAllListeners("request");
  page.removeAllListeners("requestfailed");
  page.removeAllListeners("console");
}

await testSite(async (visitor) => {
  for (const [index, path] of wrong.entries()) {
    for (const width of [1440, 360]) {
      await visitor.visit(
        path,
        { width, scheme: index % 2 ? "dark" : "light", before: forgive },
        async (page) => {
          visitor.expect(await page.evaluate(isStyled), path, "it is not styled");
          const shift = await shiftOf(page);
          visitor.expect(shift <= mostShifted, path, `what is on the page moves by ${shift}`);
          for (const violation of await violations(page)) visitor.complain(path, violation);
          for (const [link, status] of await answersOf(page)) {
            visitor.expect(status === 200 || link === page.url(), path, `${status} for ${link}`);
          }
          const images = await page.evaluate(() =>
            [...document.images].every((one) => one.naturalWidth > 0),
          );
          visitor.expect(images, path, "a picture is missing");
          await page.getByRole("button", { name: /Search for “generalised coordinates”/i }).click();
          await page.getByRole("option").first().waitFor();
          await page.keyboard.press("Enter");
          await page.waitForURL(/generalized-coordinates/);
        },
      );
    }
    await visitor.visit(path, { javaScript: false, before: forgive }, async (page) => {
      visitor.expect(await page.evaluate(isStyled), path, "it is not styled without JavaScript");
      const help = await page.getByText("shorten the address").isVisible();
      visitor.expect(help, path, "without JavaScript nothing says how to go on");
      const links = await page.getByRole("link").filter({ visible: true }).count();
      visitor.expect(links <= 1, path, "without JavaScript there are links that lead nowhere"); // "Skip"
    });
  }
});
