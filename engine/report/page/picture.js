// Only the view, for pictures: some times side by side over one bar of colours. The part of the
// address behind # says what is shown, as docs/pictures.py writes it.
import { paint_bar } from "./colours.js";
import { Frames } from "./decode.js";
import { range_of } from "./run.js";
import { View } from "./scene.js";
import { element, number_text, tick_texts, words_of } from "./text.js";

const TITLE = 30, BAR = 70, GAP = 10;

function nearest(times, time) {
  return times.reduce((best, t, i) => (Math.abs(t - time) < Math.abs(times[best] - time) ? i : best), 0);
}

/** Round numbers from `low` to `high`, about five. */
function marks_between(low, high) {
  const least = (high - low) / 6;
  const power = 10 ** Math.floor(Math.log10(least));
  const step = power * [1, 2, 2.5, 5, 10].find((factor) => factor * power >= least);
  const first = Math.ceil(low / step - 1e-6);
  const count = Math.floor(high / step + 1e-6) - first + 1;
  return Array.from({ length: count }, (_, i) => Number(((first + i) * step).toPrecision(9)));
}

function draw_bar(context, width, top, [low, high], label) {
  const bar = element("canvas", { width: 1, height: 256 });
  paint_bar(bar, low, high);
  const length = Math.min(420, 0.6 * width), left = (width - length) / 2;
  context.save();
  context.translate(left, top + 12);
  context.rotate(-Math.PI / 2);
  context.scale(1, -1);
  context.drawImage(bar, -12, -length, 12, length);
  context.restore();
  context.fillStyle = "#22262b";
  context.textAlign = "center";
  const marks = marks_between(low, high), texts = tick_texts(marks);
  marks.forEach((mark, i) => {
    const at = left + ((mark - low) / (high - low)) * length;
    context.fillRect(at - 0.5, top + 24, 1, 4);
    context.fillText(texts[i], at, top + 42);
  });
  context.fillText(label, width / 2, top + 61);
}

export async function show_picture(run, wishes) {
  const [width, height] = (wishes.get("size") ?? "1100,700").split(",").map(Number);
  const numbers = (name, fallback) => (wishes.has(name) ? wishes.get(name).split(",").map(Number) : fallback);
  const wanted = numbers("times", [run.times.at(-1)]).map((time) => nearest(run.times, time));
  const field = Math.max(0, run.fields.findIndex(({ name }) => name === wishes.get("field")));
  const scale = Number(wishes.get("scale") ?? 1);
  const [azimuth, elevation] = numbers("view", [-60, 25]);
  const range = numbers("range", range_of(run.fields[field]));

  document.body.classList.add("picture");
  const sheet = element("canvas", { id: "picture", width, height });
  const drawing = element("canvas");
  document.body.append(sheet);
  const frames = new Frames(run);
  await frames.load(() => {});

  const view = new View(drawing, run);
  view.renderer.setClearColor(0xffffff, 1);
  view.colour(field, ...range);
  const rows = wishes.has("stack") ? wanted.length : 1, columns = wanted.length / rows;
  const part = Math.floor((width - GAP * (columns - 1)) / columns);
  const tall = Math.floor((height - BAR) / rows) - TITLE;
  const cut = wishes.get("cut") && { axis: wishes.get("cut"), place: Number(wishes.get("place") ?? 0.5), flip: false };
  const context = sheet.getContext("2d");
  context.fillStyle = "#fff";
  context.fillRect(0, 0, width, height);
  context.font = "14px 'DejaVu Sans', sans-serif";
  context.textAlign = "center";
  wanted.forEach((frame, i) => {
    view.look_from({ azimuth, elevation, zoom: Number(wishes.get("zoom") ?? 1), up: wishes.get("up") ?? run.up });
    if (cut) cut.flip = view.camera.position[cut.axis] < view.middle[cut.axis]; // what is cut off lies in front
    view.resize(part, tall, 1);
    view.show(frames.at(frame), {
      frame, field, cut: cut || null, particles: wishes.has("particles"), walls: wishes.has("walls"),
    });
    view.draw();
    const left = (i % columns) * (part + GAP), top = Math.floor(i / columns) * (tall + TITLE);
    context.drawImage(drawing, left, top + TITLE, part, tall);
    context.fillStyle = "#22262b";
    if (wanted.length > 1) context.fillText(`t = ${number_text(run.times[frame])} s`, left + part / 2, top + 20);
  });
  const { label, unit } = run.fields[field];
  const fallback = unit === "1" ? words_of(label) : `${words_of(label)} [${unit}]`;
  draw_bar(context, width, height - BAR, range.map((value) => value * scale), wishes.get("label") ?? fallback);
  document.body.dataset.ready = "yes";
}
