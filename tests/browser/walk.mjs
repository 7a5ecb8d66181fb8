// Walks through pages in Chromium and says what is in the way:
//
//   walk.mjs [--shots DIR] [--click SELECTOR] PAGE...     PAGE a file or a URL
//
// Each page is opened 1300 and 390 px wide, in light and dark colours, and printed. One line a page with what was counted; a
// line for each fault: an error or a warning on the console, a request that fails or leaves the machine, a page wider than the
// screen, an issue that axe-core calls serious or critical. Exit code 1 if there is a fault. --shots keeps pictures and the PDF,
// --click presses what matches (folds, say) before a page is examined.

import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const { values: options, positionals: pages } = parseArgs({
  allowPositionals: true,
  options: { shots: { type: "string" }, click: { type: "string" } },
});
if (options.shots) mkdirSync(options.shots, { recursive: true });

const isLocal = (url) => /^(file|data|blob|about|devtools):|^https?:\/\/(localhost|127\.0\.0\.1)[:/]/.test(url);

/** The issues of a page that axe-core calls serious or critical, one line each with the first places. */
async function issues(page) {
  await page.evaluate(axe);
  // Inside a formula or a drawing are the colours and the name of the whole; what is folded away is examined where --click opens it.
  const { violations } = await page.evaluate(() =>
    axe.run({ exclude: [["math > *"], ["svg > *"], ["details:not([open]) > :not(summary)"]] }, { resultTypes: ["violations"], elementRef: false }));
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, impact, nodes }) => {
      const places = nodes.slice(0, 3).map(({ target, any }) => `${target.join(" ")} ${any[0]?.message ?? ""}`.trim());
      return `axe ${impact} ${id}, ${nodes.length} times: ${places.join(" | ")}`;
    });
}

/** What overflows a page: of the elements beyond its right edge the outermost. */
const tooWide = () => {
  const edge = document.documentElement.clientWidth;
  if (document.documentElement.scrollWidth <= edge) return [];
  const beyond = [...document.body.querySelectorAll("*")].filter((e) => e.getBoundingClientRect().right > edge + 1);
  return beyond.slice(0, 3).map((e) => `wider than ${edge} px: ${e.tagName.toLowerCase()}#${e.id}.${e.className}`);
};

async function walk(browser, address) {
  const url = /^[a-z]+:\/\//.test(address) ? address : pathToFileURL(resolve(address)).href;
  const name = basename(new URL(url).pathname).replace(/\.\w+$/, "") || "index";
  const faults = new Set();
  let height = 0;
  let printed = 0;
  for (const [width, tall] of [[1300, 1600], [390, 844]]) {
    for (const colorScheme of ["light", "dark"]) {
      const context = await browser.newContext({ viewport: { width, height: tall }, colorScheme });
      const page = await context.newPage();
      page.on("console", (message) => {
        if (["error", "warning"].includes(message.type())) faults.add(`console ${message.type()}: ${message.text()}`);
      });
      page.on("pageerror", (error) => faults.add(`uncaught: ${error.message}`));
      page.on("requestfailed", (request) => faults.add(`failed: ${request.url()}`));
      page.on("request", (request) => { if (!isLocal(request.url())) faults.add(`leaves the machine: ${request.url()}`); });
      await page.goto(url, { waitUntil: "load" });
      await page.waitForTimeout(300);
      if (options.click) {
        for (const button of await page.locator(options.click).all()) await button.click();
      }
      for (const fault of [...(await issues(page)), ...(await page.evaluate(tooWide))]) {
        faults.add(`${width} px, ${colorScheme}: ${fault}`);
      }
      height ||= await page.evaluate(() => document.documentElement.scrollHeight);
      if (options.shots) await page.screenshot({ path: `${options.shots}/${name}-${width}-${colorScheme}.png` });
      if (width === 1300 && colorScheme === "light") {
        const path = options.shots ? `${options.shots}/${name}.pdf` : undefined;
        const pdf = await page.pdf({ path, preferCSSPageSize: true });
        printed = (pdf.toString("latin1").match(/\/Type ?\/Page[^s]/g) ?? []).length;
      }
      await context.close();
    }
  }
  console.log(`${address}: ${height} px high at 1300, ${printed} pages printed, ${faults.size} faults`);
  for (const fault of faults) console.log(`  ${fault}`);
  return faults.size;
}

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"],
});
let faults = 0;
for (const page of pages) faults += await walk(browser, page);
await browser.close();
process.exit(faults === 0 ? 0 : 1);
