// Builds the page: node build.mjs [FOLDER], by default dist.
import { build } from "esbuild";
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

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
await build({
  entryPoints: ["styles/studio.css"],
  bundle: true,
  minify: true,
  outfile: join(out, "studio.css"),
  logLevel: "warning",
});
for (const file of ["index.html", "icon.svg"]) cpSync(file, join(out, file));
// Sent to browsers that understand it, which all do.
for (const file of ["index.html", "studio.css", "studio.js"]) {
  writeFileSync(join(out, `${file}.gz`), gzipSync(readFileSync(join(out, file)), { level: 9 }));
}
