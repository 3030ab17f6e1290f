// Builds the pages of the studio, of studies and of shared recordings: node build.mjs [FOLDER], by default dist.
import { build } from "esbuild";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync } from "node:fs";
import { join } from "node:path";

const out = process.argv[2] ?? "dist";

/** Builds a page of one script, which loads the texts of its language, one style sheet and the files beside them. */
async function buildPage(folder, { name, script, style, files }) {
  mkdirSync(folder, { recursive: true });
  const { metafile } = await build({
    entryPoints: [{ in: script, out: name }],
    bundle: true,
    splitting: true,
    chunkNames: "[name]",
    metafile: true,
    minify: true,
    sourcemap: true,
    format: "esm",
    target: "es2022",
    jsx: "automatic",
    jsxImportSource: "preact",
    outdir: folder,
    logLevel: "warning",
  });
  await build({
    entryPoints: [style],
    bundle: true,
    minify: true,
    outfile: join(folder, `${name}.css`),
    logLevel: "warning",
  });
  for (const [from, to] of files) cpSync(from, join(folder, to));
  // Sent to browsers that understand it, which all do. What Node itself compresses is 1 % larger.
  const scripts = Object.keys(metafile.outputs).filter((file) => file.endsWith(".js"));
  const sent = [join(folder, "index.html"), join(folder, `${name}.css`), ...scripts];
  execFileSync("gzip", ["--best", "--keep", "--force", "--no-name", ...sent]);
}

await buildPage(out, {
  name: "studio",
  script: "src/main.tsx",
  style: "styles/studio.css",
  files: [["index.html", "index.html"], ["icon.svg", "icon.svg"]],
});
await buildPage(join(out, "study"), {
  name: "study",
  script: "src/study/main.tsx",
  style: "styles/study.css",
  files: [["study.html", "index.html"], ["icon.svg", "icon.svg"]],
});
await buildPage(join(out, "shared"), {
  name: "shared",
  script: "src/shared/main.tsx",
  style: "styles/shared.css",
  files: [["shared.html", "index.html"], ["icon.svg", "icon.svg"]],
});
