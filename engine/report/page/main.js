import { show_batch } from "./batch.js";
import { show_picture } from "./picture.js";
import { show_run } from "./run.js";
import { by_id } from "./text.js";

const run = JSON.parse(by_id("run").textContent);
const wishes = new URLSearchParams(location.hash.slice(1));
const show = run.kind === "batch" ? show_batch : wishes.has("picture") ? show_picture : show_run;
Promise.resolve(show(run, wishes)).catch((error) => {
  by_id("state").textContent = `This page cannot be shown: ${error.message}`;
  throw error;
});
