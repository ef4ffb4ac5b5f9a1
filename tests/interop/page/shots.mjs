// shots.mjs URL PICTURE [PICK]: saves a picture of the page of the example town over its old town; PICK: a place is picked.
import { OpenPage } from "./open_page.mjs";

const [url, picture, pick] = process.argv.slice(2);
const open = await OpenPage.open(`${url}#detail=8`, { size: { width: 1200, height: 675 } });
await open.put(20, -210, 38, -0.1, -0.3);
if (pick) {
  await open.page.mouse.click(760, 330);
  await open.page.waitForSelector("#feature:not([hidden])");
}
await open.still();
await open.page.screenshot({ path: picture, type: "jpeg", quality: 88 });
await open.close();
