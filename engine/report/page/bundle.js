// Writes ../bundle/page.html: the page of a report with its style and scripts inside, and with places
// for the title and the data of a run. An argument is another file to write to.
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";

const here = new URL(".", import.meta.url);
const read = (name) => readFileSync(new URL(name, here), "utf8");

/** One file with all that the entry imports, for browsers of 2023 and later. */
async function bundled(entry) {
  const { outputFiles } = await build({
    absWorkingDir: here.pathname,
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    legalComments: "none",
    charset: "ascii",
    format: "iife",
    target: ["chrome110", "firefox115", "safari16.4"],
  });
  return outputFiles[0].text.trim();
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
const parts = {
  style: await bundled("style.css"),
  script: (await bundled("main.js")).replaceAll("</script", "<\\/script"),
  "licence-three": escaped(read("node_modules/three/LICENSE").trim()),
  "licence-uplot": escaped(read("node_modules/uplot/LICENSE").trim()),
};
let page = read("page.html");
for (const [name, text] of Object.entries(parts)) page = page.replace(`<!--${name}-->`, () => text);
writeFileSync(process.argv[2] ?? new URL("../bundle/page.html", here), page);
