// Small runs by the program itself, and their files as a test reads them.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export function porefines(folder, ...words) {
  return execFileSync(process.env.PF_BINARY, words, {
    cwd: folder, encoding: "utf8", env: { ...process.env, OMPI_ALLOW_RUN_AS_ROOT: "1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM: "1" },
  });
}

/** Runs a case and writes its report; returns the folder of the run. */
function written(file, ...changes) {
  const out = join(mkdtempSync(join(tmpdir(), "porefines_page_")), "out");
  porefines(".", "run", file, ...changes, "-o", out);
  porefines(".", "report", out);
  return out;
}

/** The same for a case as text. */
function reported(text, files = {}) {
  const folder = mkdtempSync(join(tmpdir(), "porefines_case_"));
  writeFileSync(join(folder, "case.toml"), text);
  Object.entries(files).forEach(([name, content]) => writeFileSync(join(folder, name), content));
  return written(join(folder, "case.toml"));
}

export function summary(folder) {
  return JSON.parse(readFileSync(join(folder, "summary.json"), "utf8"));
}

/** Columns of a CSV table; words stay words. */
export function table(folder, name) {
  const [head, ...rows] = readFileSync(join(folder, name), "utf8").trim().split("\n").map((line) => line.split(","));
  return Object.fromEntries(head.map((column, c) => [column, rows.map((row) => (Number.isNaN(Number(row[c])) ? row[c] : Number(row[c])))]));
}

const throat = new URL("../../cases/throat/case.toml", import.meta.url).pathname;

/** Water between two pillars. */
export const flowRun = () => reported(`title = "Two pillars"
[geometry]
kind = "cylinders"
source = "pillars.txt"
size = ["40 um", "24 um", "12 um"]
list_unit = "1 um"
periodic_images = false
[grid]
cell_size = "1.3333333333333333 um"
[flow]
inlet = { face = "x-", pressure = "10 Pa" }
outlet = { face = "x+", pressure = "0 Pa" }
walls = ["z-", "z+"]
slip = ["y-", "y+"]
`, { "pillars.txt": "20 0 8\n20 24 8\n" });

/** A fine that is sieved between them. */
export const coupledRun = () => written(throat, "title=A sieved fine </script>",
  'output=[{kind="tracks", every="2 ms", forces=true}, {kind="summary", every="2 ms"}, {kind="fields"}]');

/** Balls that fall, without a fluid. */
export const dryRun = () => reported(`title = "Two balls"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[run]
end_time = "20 ms"
[geometry]
kind = "empty"
size = ["4 mm", "4 mm", "4 mm"]
[[particles]]
source = "balls.csv"
[[output]]
kind = "tracks"
every = "1 ms"
`, { "balls.csv": "x_m,y_m,z_m,diameter_m\n1e-3,1e-3,2e-3,5e-4\n3e-3,3e-3,3e-3,5e-4\n" });

/** A stream around a cylinder of eight cells. */
export const inertialRun = () => reported(`title = "A stream"
[run]
end_time = "0.8 ms"
[geometry]
kind = "cylinders"
source = "cylinder.txt"
size = ["1.6 mm", "1.2 mm", "25 um"]
list_unit = "1 mm"
periodic_images = false
[grid]
cell_size = "25 um"
[fluid]
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[flow]
regime = "navier-stokes"
inlet = { face = "x-", velocity = "0.5 m/s" }
outlet = { face = "x+", pressure = "5 Pa" }
slip = ["y-", "y+", "z-", "z+"]
reservoir = "0 m"
[[output]]
kind = "summary"
every = "0.1 ms"
`, { "cylinder.txt": "0.5 0.6 0.1\n" });
