// A run: its view, its plots and its tables.
import { is_signed, paint_bar } from "./colours.js";
import { Frames } from "./decode.js";
import { add_history } from "./plots.js";
import { View } from "./scene.js";
import { add_conserved, add_measurements, add_phases, add_settings, add_speed } from "./tables.js";
import { by_id, label_of, number_text, with_unit, words_of } from "./text.js";

const LOOP_SECONDS = 6; // of all frames, when they play

function facts_of(run) {
  const { summary } = run;
  const facts = [run.case, `${words_of(run.method)} method`, `${run.dimension}D`];
  if (summary) facts.push(`${summary.particles.end.toLocaleString("en")} particles`, `${summary.steps.toLocaleString("en")} steps`);
  if (run.times.length > 0) facts.push(`${with_unit(number_text(run.times.at(-1)), "s")} simulated`);
  if (summary) facts.push(`${with_unit(number_text(summary.wall_time), "s")} of wall time`);
  return facts.join("  ·  ");
}

/** The ends of the colours for a field: those of its values, even about zero where they have both signs. */
export function range_of({ lo, hi }) {
  const most = Math.max(-lo, hi);
  if (is_signed(lo, hi)) return [-most, most];
  return hi > lo ? [lo, hi] : [lo - 0.5 * (Math.abs(lo) || 1), lo + 0.5 * (Math.abs(lo) || 1)];
}

class Controls {
  constructor(run, frames, view, marks) {
    Object.assign(this, { run, frames, view, marks });
    this.slider = by_id("frame");
    this.slider.max = run.times.length - 1;
    for (const field of run.fields) by_id("field").append(new Option(label_of(field.label, field.unit)));
    by_id("up").value = run.up;
    by_id("cut-choice").hidden = by_id("up-choice").hidden = run.dimension === 2;
    by_id("shape-choice").hidden = !((view.face || view.filling) && view.particles_at >= 0);
    by_id("wall-choice").hidden = run.walls.length === 0;
    this.listen();
    this.choose_field();
    this.show();
  }

  get frame() {
    return Number(this.slider.value);
  }

  listen() {
    const on = (id, event, action) => by_id(id).addEventListener(event, action.bind(this));
    on("frame", "input", this.show);
    on("field", "change", this.choose_field);
    on("place", "input", this.show);
    for (const id of ["cut", "flip", "particles", "walls"]) on(id, "change", this.show);
    for (const id of ["lowest", "highest"]) on(id, "change", this.choose_range);
    on("up", "change", () => this.view.look_from({ up: by_id("up").value }));
    on("reset", "click", () => this.view.look_from({}));
    on("play", "click", this.play);
    on("canvas", "keydown", this.key);
    new ResizeObserver(() => this.view.resize()).observe(by_id("stage"));
  }

  key(event) {
    const turns = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
    const zooms = { "+": 1.1, "=": 1.1, "-": 1 / 1.1 };
    if (turns[event.key]) this.view.turn(...turns[event.key]);
    else if (zooms[event.key]) this.view.zoom_by(zooms[event.key]);
    else if (event.key === "r" || event.key === "R") this.view.look_from({});
    else if (event.key === " ") this.play();
    else return;
    event.preventDefault();
  }

  choose_field() {
    this.field = by_id("field").selectedIndex;
    this.range = range_of(this.run.fields[this.field]);
    this.colour();
    this.show();
  }

  choose_range() {
    const [low, high] = [by_id("lowest"), by_id("highest")].map((input) => Number(input.value));
    if (Number.isFinite(low) && Number.isFinite(high) && low < high) this.range = [low, high];
    this.colour();
  }

  colour() {
    const [low, high] = this.range;
    by_id("lowest").value = number_text(low);
    by_id("highest").value = number_text(high);
    paint_bar(by_id("bar"), low, high);
    this.view.colour(this.field, low, high);
  }

  show() {
    const axis = by_id("cut").value;
    by_id("cut-place").hidden = by_id("cut-side").hidden = axis === "";
    const cut = axis && { axis, place: Number(by_id("place").value), flip: by_id("flip").checked };
    const text = `t = ${with_unit(number_text(this.run.times[this.frame]), "s")}`;
    by_id("time").textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
    const sets = this.frames.at(this.frame);
    if (sets) {
      this.view.show(sets, {
        frame: Math.min(this.frame, this.frames.loaded.length - 1), field: this.field, cut: cut || null,
        particles: by_id("particles").checked, walls: by_id("walls").checked,
      });
    }
    this.marks.forEach((mark) => mark());
  }

  go_to(time) {
    const { times } = this.run;
    const nearest = times.reduce((best, t, i) => (Math.abs(t - time) < Math.abs(times[best] - time) ? i : best), 0);
    this.slider.value = nearest;
    this.show();
  }

  play() {
    this.is_playing = !this.is_playing;
    by_id("play").textContent = this.is_playing ? "Pause" : "Play";
    by_id("play").setAttribute("aria-pressed", String(this.is_playing));
    if (!this.is_playing) return;
    const count = this.run.times.length;
    const start = performance.now() - ((this.frame % (count - 1 || 1)) / count) * LOOP_SECONDS * 1000;
    const advance = (now) => {
      if (!this.is_playing) return;
      const next = Math.floor((Math.max(0, now - start) / (LOOP_SECONDS * 1000)) * count) % count;
      if (next !== this.frame) {
        this.slider.value = next;
        this.show();
      }
      requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }
}

function add_text(run) {
  document.title = run.title || run.case;
  by_id("title").textContent = run.title || run.case;
  by_id("facts").textContent = facts_of(run);
  by_id("notes").textContent = run.notes.join("\n");
}

function add_tables(run) {
  const tables = by_id("tables");
  if (run.summary) {
    add_measurements(tables, run.summary);
    add_conserved(tables, run.summary);
    add_phases(tables, run.summary);
    add_speed(tables, run.summary);
  }
  add_settings(tables, run.settings);
}

/** None where the browser cannot draw in 3D; plots and tables are shown all the same. */
function view_of(run) {
  try {
    return new View(by_id("canvas"), run);
  } catch (error) {
    by_id("state").textContent = `The view needs WebGL 2 and a browser of 2023 or later (${error.message}).`;
    return null;
  }
}

export async function show_run(run, wishes) {
  add_text(run);
  let controls = null;
  const marks = [];
  const add_plots = () => {
    for (const history of run.histories) {
      marks.push(add_history(by_id("plots"), history,
        () => (controls ? run.times[controls.frame] : null), (time) => controls?.go_to(time)));
    }
    add_tables(run);
  };
  if (run.times.length === 0) {
    add_plots();
    return;
  }
  by_id("view").hidden = false;
  const frames = new Frames(run);
  const view = view_of(run);
  if (!view) {
    add_plots();
    return;
  }
  view.up = run.up;
  view.look_from({});
  const count = frames.count;
  await frames.load((index) => {
    if (index === 0) {
      controls = new Controls(run, frames, view, marks);
      controls.field = 0;
      view.draw();
      performance.mark("first-picture");
      setTimeout(add_plots);
    } else if (index === controls.frame || (index < controls.frame && index % 8 === 0)) {
      controls.show();
    }
    by_id("state").textContent = index + 1 < count ? `Loading ${index + 1} of ${count} frames` : "";
  });
  by_id("stage").dataset.loaded = "yes";
}
