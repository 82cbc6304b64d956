// Moves the mouse of a real browser by `pointpred/human`; writes what the page and the test have seen as JSON.
// Copied beside the packages that it needs; given as arguments: the driver, the browser, the address of the page, the seed.
import { human } from "pointpred/human";

const [, , name, executablePath, address, seed] = process.argv;
const args = ["--no-sandbox", "--disable-gpu"];
const start = {
  playwright: async () => (await import("playwright-core")).chromium.launch({ executablePath, args }),
  puppeteer: async () => (await import("puppeteer-core")).default.launch({ executablePath, args }),
};
const browser = await start[name]();
const page = await browser.newPage();
await page.goto(address);
const hand = human(page, { seed: Number(seed) });
const attempt = (target) => hand.moveTo(target).catch(({ message }) => message);

await hand.moveTo("#cart");
const rested = hand.at;
await hand.click("#cart");
await hand.moveTo({ x: 10, y: 20 });
await hand.click(await page.$("#middle"));
const told = [await attempt("#nothing"), await attempt({ x: 5000, y: 20 })];
const { seen, automated } = await page.evaluate("({ seen, automated: navigator.webdriver })");
await browser.close();
console.log(JSON.stringify({ rested, told, seen, automated }));
