// Makes page.html: the bundled script and styles inside src/page.html. Run by CMake (cmake/web.cmake).
import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const bundle = async (entry) => {
  const made = await build({
    entryPoints: [entry],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: "es2022",
    legalComments: "none",
    logLevel: "warning",
  });
  return made.outputFiles[0].text;
};

const script = (await bundle("src/main.js")).replaceAll("</script", "<\\/script");
const styles = await bundle("src/style.css");
const page = readFileSync("src/page.html", "utf8")
  .replace("/* STYLES */", () => styles)
  .replace("/* SCRIPT */", () => script);
writeFileSync("page.html", page);
