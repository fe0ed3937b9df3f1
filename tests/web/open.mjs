// Opens a page in headless Chromium without a network and hands back what it said.
import { createRequire } from "node:module";

const require = createRequire(`${process.env.PF_WEB}/`);
const { chromium } = require("playwright-core");

const quiet = [
  "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync",
];

let browser = null; // one for all pages of a test program

export async function closeBrowser() {
  await browser?.close();
}

/** @returns {{ page, complaints, asked, close }}  asked: addresses that the page wanted from elsewhere */
export async function openPage(path, { width = 1400, dark = false } = {}) {
  browser ??= await chromium.launch({ executablePath: process.env.PF_CHROMIUM, args: quiet });
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme: dark ? "dark" : "light", offline: true, acceptDownloads: true });
  const page = await context.newPage();
  const complaints = [];
  const asked = [];
  page.on("console", (message) => {
    if (message.type() === "error") {
      complaints.push(message.text());
    }
  });
  page.on("pageerror", (error) => complaints.push(error.stack));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) {
      asked.push(request.url());
    }
  });
  await page.goto(`file://${path}`);
  await page.waitForSelector("html[data-ready]", { state: "attached", timeout: 60000 });
  return { page, complaints, asked, close: () => context.close() };
}
