// Makes the bundle that the robot serves, out of the sources. `node build.mjs`: writes bundle/. `node build.mjs --check`: only
// tells whether bundle/ is what the sources make. GAITWAY_PAGE_PACKAGES: the folder with node_modules.
import { createHash } from "node:crypto";
import { createRequire } from "node:module";
import { mkdir, readFile, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const packages = path.resolve(process.env.GAITWAY_PAGE_PACKAGES ?? path.join(here, "../../.deps/web"));
const { build } = createRequire(path.join(packages, "package.json"))("esbuild");
const bundle = path.join(here, "bundle");
const mostBytes = 1_000_000;
const versionMark = "the-version-of-this-page"; // in whose place the script gets what the bundle's contents make

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
  define: { PAGE_VERSION: JSON.stringify(versionMark) },
  write: false,
});
const files = new Map(outputFiles.map(({ path: file, contents }) => [path.basename(file), Buffer.from(contents)]));
for (const name of ["index.html", "icon.svg"]) files.set(name, await readFile(path.join(here, "src", name)));

const hash = createHash("sha256");
for (const contents of files.values()) hash.update(contents);
const version = hash.digest("hex").slice(0, 16);
const script = files.get("page.js").toString();
if (!script.includes(versionMark)) throw new Error("the script has no place for its version: see src/page_version.ts");
files.set("page.js", Buffer.from(script.replaceAll(versionMark, version)));
files.set("version.json", Buffer.from(`{"page":"${version}"}\n`));

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
