// Builds the page: node build.mjs [FOLDER], by default dist.
import { build } from "esbuild";
import { cpSync, mkdirSync } from "node:fs";
import { join } from "node:path";

const out = process.argv[2] ?? "dist";
mkdirSync(out, { recursive: true });
await build({
  entryPoints: ["src/main.tsx"],
  bundle: true,
  minify: true,
  sourcemap: true,
  format: "esm",
  target: "es2022",
  jsx: "automatic",
  jsxImportSource: "preact",
  outfile: join(out, "studio.js"),
  logLevel: "warning",
});
for (const file of ["index.html", "studio.css", "icon.svg"]) cpSync(file, join(out, file));
