// Curves over time, and points over parameters.
import uPlot from "uplot";
import { element, number_text, style_of, tick_texts, unit_text, with_unit, words_of } from "./text.js";

const made = []; // { remake } of all plots, for changes of size and of light and dark

function axis(label) {
  return {
    label,
    labelSize: 22,
    labelGap: 2,
    font: "11px system-ui, sans-serif",
    labelFont: "12px system-ui, sans-serif",
    stroke: style_of("--faint"),
    grid: { stroke: style_of("--grid"), width: 1 },
    ticks: { stroke: style_of("--line"), width: 1, size: 4 },
    values: (_, numbers) => tick_texts(numbers),
  };
}

function options(card, x_label, y_label, series, more) {
  const y = axis(y_label);
  y.size = (plot, labels) => 14 + 6.4 * Math.max(3, ...(labels ?? []).map((text) => text.length));
  return {
    width: Math.max(200, card.clientWidth - 24),
    height: 220,
    padding: [8, 16, 0, 0],
    scales: { x: { time: false } },
    axes: [{ ...axis(x_label), size: 30 }, y],
    series: [{}, ...series],
    legend: { show: false },
    cursor: { y: false, points: { size: 6 } },
    ...more,
  };
}

function add(card, make) {
  const one = { remake() {
    one.plot?.destroy();
    one.plot = make();
  } };
  one.remake();
  made.push(one);
  let width = card.clientWidth;
  new ResizeObserver(() => {
    if (card.clientWidth === width) return;
    width = card.clientWidth;
    one.plot.setSize({ width: Math.max(200, width - 24), height: 220 });
  }).observe(card);
  return one;
}

matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => made.forEach((one) => one.remake()));

const curve = (label, colour, more = {}) => ({ label, stroke: style_of(colour), width: 1.6, points: { show: false }, spanGaps: true, ...more });

/** Curves on one axis of all their times. */
function joined(curves) {
  return uPlot.join(curves.map(({ time, value }) => [time, value]));
}

/**
 * A card with a history and its reference curves. `at()` gives the time of the view, `choose(time)`
 * moves it there. Returns a function that marks the time of the view.
 */
export function add_history(parent, history, at, choose) {
  const now = element("span", { class: "now" });
  const card = element("article", { class: "card plot" }, element("h2", {}, words_of(history.name), now));
  parent.append(card);
  const references = history.references ?? [];
  if (references.length > 0) {
    card.append(element("p", {}, `Dashed: reference (${references.map((one) => words_of(one.name)).join(", ")})`));
  }
  const data = joined([history, ...references]);
  const last = history.value.findLast((value) => value !== null);
  now.textContent = history.value.length > 0 ? with_unit(number_text(last), history.unit) : "no value";
  const mark = (plot) => {
    const time = at();
    if (time === null) return;
    const x = Math.round(plot.valToPos(time, "x", true));
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = style_of("--faint");
    ctx.globalAlpha = 0.6;
    ctx.setLineDash([]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  };
  const one = add(card, () => {
    const series = [curve(history.name, "--accent"), ...references.map((r) => curve(r.name, "--accent-2", { dash: [6, 4] }))];
    const plot = new uPlot(options(card, "time [s]", unit_text(history.unit), series, {
      hooks: { draw: [mark] },
    }), data, card);
    plot.over.addEventListener("click", () => choose(plot.posToVal(plot.cursor.left, "x")));
    return plot;
  });
  return () => one.plot.redraw(false);
}

/** Points at the very end of an axis would be left out where several have the same place. */
function padded(_, least, most) {
  const margin = 0.06 * (most - least) || 0.1 * Math.abs(least) || 1;
  return [least - margin, most + margin];
}

/** A card with one point for each run: a measurement over a parameter. */
export function add_points(parent, { name, unit, over, x, y }) {
  const card = element("article", { class: "card plot" }, element("h2", {}, words_of(name)));
  parent.append(card);
  const order = x.map((_, i) => i).sort((a, b) => x[a] - x[b]);
  const data = [order.map((i) => x[i]), order.map((i) => y[i])];
  add(card, () => {
    const colour = style_of("--accent");
    const series = [{ label: name, paths: () => null, stroke: colour, points: { show: true, size: 7, fill: colour, stroke: colour } }];
    return new uPlot(options(card, over, unit_text(unit), series, { scales: { x: { time: false, range: padded } } }), data, card);
  });
}
