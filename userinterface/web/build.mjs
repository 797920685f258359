// Makes the bundle that the robot serves, out of the sources. `node build.mjs`: writes bundle/. `node build.mjs --check`: only
// tells whether bundle/ is what the sources make. GAITWAY_PAGE_PACKAGES: the folder with node_modules.
import { createRequire } from "node:module";
import { mkdir, readFile, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const packages = path.resolve(process.env.GAITWAY_PAGE_PACKAGES ?? path.join(here, "../../.deps/web"));
const { build } = createRequire(path.join(packages, "package.json"))("esbuild");
const bundle = path.join(here, "bundle");
const mostBytes = 1_000_000;

const { outputFiles } = await build({
  absWorkingDir: here,
  entryPoints: { page: "src/main.ts" },
  outdir: bundle,
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "inline",
  nodePaths: [path.join(packages, "node_modules")],
  logLevel: "warning",
  write: false,
});
const files = new Map(outputFiles.map(({ path: file, contents }) => [path.basename(file), Buffer.from(contents)]));
for (const name of ["index.html", "icon.svg"]) files.set(name, await readFile(path.join(here, "src", name)));

const bytes = [...files.values()].reduce((sum, contents) => sum + contents.length, 0);
if (bytes > mostBytes) throw new Error(`the bundle has ${bytes} bytes, but at most ${mostBytes} are wanted`);

if (process.argv.includes("--check")) {
  for (const [name, contents] of files) {
    const there = await readFile(path.join(bundle, name)).catch(() => undefined);
    if (there?.equals(contents)) continue;
    console.error(`userinterface/web/bundle/${name} is not what the sources make. Run ./dev web`);
    process.exit(1);
  }
  console.log(`the bundle is what the sources make: ${bytes} bytes`);
} else {
  await rm(bundle, { recursive: true, force: true });
  await mkdir(bundle);
  for (const [name, contents] of files) await writeFile(path.join(bundle, name), contents);
  console.log(`bundle: ${bytes} bytes`);
}
