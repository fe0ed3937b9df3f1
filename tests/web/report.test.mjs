// The page of porefines report in headless Chromium, without a network: it opens without complaints,
// its plots hold the run's own numbers, the player plays, a row of the clogging log finds its place.
import assert from "node:assert/strict";
import { existsSync, rmSync, statSync } from "node:fs";
import { dirname } from "node:path";
import { after, test } from "node:test";
import { closeBrowser, openPage } from "./open.mjs";
import { coupledRun, dryRun, flowRun, inertialRun, summary, table } from "./runs.mjs";

if (!existsSync(process.env.PF_CHROMIUM ?? "")) {
  console.log("skipped: no chromium on this machine (apt-get install chromium)");
  process.exit(77);
}

/** Folders of runs, made when they are first asked for. */
const folders = new Map();
after(async () => {
  await closeBrowser();
  folders.forEach((folder) => rmSync(dirname(folder), { recursive: true }));
});

/** Opens the report of a run, checks what holds for every page, then what `look` checks. */
async function withPage(run, options, look) {
  if (!folders.has(run)) {
    folders.set(run, run());
  }
  const folder = folders.get(run);
  assert.ok(statSync(`${folder}/report.html`).size < 3e6);
  const { page, complaints, asked, close } = await openPage(`${folder}/report.html`, options);
  try {
    await look(page, folder);
    assert.deepEqual(complaints, []);
    assert.deepEqual(asked, []);
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= (options.width ?? 1400), `the page is ${width} pixels wide`);
    const text = await page.evaluate(() => document.getElementById("page").innerText);
    assert.doesNotMatch(text, /undefined|NaN|\bnull\b/);
  } finally {
    await close();
  }
}

/** Every trace of the page that shows a column: { figure, column, x, y } in the units of the file. */
function traces(page) {
  return page.evaluate(() => [...window.porefines.figures.values()].flatMap((figure) =>
    figure.plot.data.filter((trace) => trace.meta?.column && trace.type === "scatter").map((trace) => ({
      figure: figure.name,
      column: trace.meta.column,
      x: Array.from(trace.x, (x) => x * (trace.meta.xFactor ?? 1)),
      y: Array.from(trace.y, (y) => (y === null ? null : y * trace.meta.factor)),
    }))));
}

function near(shown, written, what) {
  assert.equal(shown.length, written.length, what);
  shown.forEach((value, k) => {
    if (value !== null && Number.isFinite(written[k])) {
      assert.ok(Math.abs(value - written[k]) <= 2e-6 * Math.abs(written[k]), `${what}[${k}]: ${value} is not ${written[k]}`);
    }
  });
}

test("a flow run shows its permeability, its pores and its flow", () => withPage(flowRun, {}, async (page, folder) => {
  const s = summary(folder);
  const cards = await page.locator(".cards").innerText();
  assert.ok(cards.includes(String(Number(s.permeability_darcy.toPrecision(4)))), cards);
  const fastest = await page.evaluate(() => {
    const { plot } = window.porefines.figures.get("speed-z");
    const { z, meta } = plot.data[0];
    return { largest: meta.factor * Math.max(...Array.from(z).flatMap((row) => Array.from(row)).filter((v) => v !== null)), pixels: plot.querySelector(".hm image") !== null };
  });
  assert.ok(fastest.pixels);
  // Between the pillars the water is faster than the mean over the pores, by the narrowing 24/8 at least.
  assert.ok(fastest.largest > (3 * s.darcy_velocity_m_s) && fastest.largest < 20 * s.darcy_velocity_m_s);
  assert.ok(await page.locator("#absent").innerText().then((text) => text.includes("This run has no particles")));
  assert.equal(await page.locator("#clogging").count(), 0);
}));

test("a coupled run shows what its tables say, plays, and finds the clog", () => withPage(coupledRun, {}, async (page, folder) => {
  const series = table(folder, "series.csv");
  const shown = (await traces(page)).filter((trace) => series[trace.column] && trace.figure !== "clogging-map");
  assert.ok(shown.length >= 10, `${shown.length} lines`);
  for (const { figure, column, x, y } of shown) {
    const along = ["mean-speed", "spread", "contacts"].includes(figure) ? "time_s" : "pore_volumes";
    near(x, series[along], `${figure} ${along}`);
    near(y, series[column], `${figure} ${column}`);
  }
  const profile = table(folder, "retention.csv");
  const bins = profile.x_m.filter((_, k) => profile.time_s[k] === profile.time_s.at(-1));
  const porosity = (await traces(page)).find((trace) => trace.figure === "porosity-profile" && trace.column === "porosity");
  near(porosity.x, bins, "profile x");
  near(porosity.y, profile.porosity.slice(-bins.length), "profile porosity");

  const tracks = table(folder, "tracks.csv");
  const last = await page.evaluate(() => window.porefines.player.shown());
  assert.equal(last.length, 1);
  assert.ok(Math.abs(last[0].x - tracks.x_m.at(-1)) < 1e-4 * 40e-6);
  await page.evaluate(() => window.porefines.player.seek(0));
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => window.porefines.player.at > 0.5);
  await page.getByRole("button", { name: "Pause" }).click();
  const moved = await page.evaluate(() => window.porefines.player.shown()[0].x);
  assert.ok(moved > tracks.x_m[0]);
  const picture = await page.evaluate(() => {
    const canvas = document.querySelector(".player canvas");
    const gl = canvas.getContext("webgl2");
    const pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return new Set(new Uint32Array(pixels.buffer)).size;
  });
  assert.ok(picture > 20, `the player shows ${picture} colours`);

  const clogs = table(folder, "clogging.csv");
  await page.locator("tr[data-row='0']").click();
  const found = await page.evaluate(() => {
    const { player } = window.porefines;
    const events = window.porefines.figures.get("clogging-map").plot.data.at(-1);
    return { time: player.frames.time(player.at), ring: player.scene.ring.visible, y: events.y[0] * events.meta.factor, size: events.marker.size[0] };
  });
  assert.ok(Math.abs(found.time - clogs.time_s[0]) < 1e-6 && found.ring && found.size > 20);
  near([found.y], [clogs.y_m[0]], "marker");
  assert.ok((await page.locator("h1").innerText()).includes("</script>"));
}));

test("each figure is saved as SVG, PNG and CSV with the run's numbers", () => withPage(coupledRun, { width: 400, dark: true }, async (page, folder) => {
  const text = async (kind) => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.locator("#permeability-ratio").getByRole("button", { name: kind }).click()]);
    const chunks = [];
    for await (const chunk of await file.createReadStream()) {
      chunks.push(chunk);
    }
    return { name: file.suggestedFilename(), bytes: Buffer.concat(chunks) };
  };
  const csv = await text("CSV");
  assert.equal(csv.name, "permeability-ratio.csv");
  const lines = csv.bytes.toString().trim().split("\n").map((line) => line.split(","));
  const column = lines[0].indexOf("permeability_ratio");
  near(lines.slice(1).map((line) => Number(line[column])), table(folder, "series.csv").permeability_ratio, "CSV");
  const svg = await text("SVG");
  assert.match(svg.bytes.toString(), /^<svg.*k \/ k/s);
  const png = await text("PNG");
  assert.equal(png.bytes.subarray(1, 4).toString(), "PNG");
  const colour = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await colour(), "rgb(20, 24, 29)");
  await page.getByRole("button", { name: "Switch to light colours" }).click();
  assert.equal(await colour(), "rgb(255, 255, 255)");
}));

test("dry runs and runs with inertia say what they do not have", async () => {
  await withPage(dryRun, {}, async (page, folder) => {
    const absent = await page.locator("#absent").innerText();
    assert.match(absent, /There is no fluid in this run/);
    const shown = await traces(page);
    near(shown.find((trace) => trace.column === "kinetic_j").y, table(folder, "series.csv").kinetic_j, "energy");
  });
  await withPage(inertialRun, {}, async (page, folder) => {
    const shown = await traces(page);
    near(shown.find((trace) => trace.figure === "body-1").y, table(folder, "series.csv").body_1_drag_coefficient, "drag");
    assert.match(await page.locator("#absent").innerText(), /This run has no particles/);
  });
});
