// SPDX-License-Identifier: GPL-3.0-or-later
// Curves with bands of error, and bars, drawn by uPlot: its legend tells the values at the pointer.

import { range, shown, shownError } from "./data.js";
import { colour, make, onTheme } from "./dom.js";
import { say } from "./texts.js";

/**
 * @typedef {{name: string, x: ArrayLike<number>, y: ArrayLike<number>, error?: ArrayLike<number>,
 *   dots?: boolean}} Series
 */

const dashes = [[], [8, 4], [2, 4], [10, 3, 2, 3]], width = 520, height = 300, font = "12px system-ui, sans-serif";

/** What is drawn of the values and their bands, with a margin, and whether it ends within a band: a few large errors
 * shall not hide the curve.
 * @param {[number, number]} values @param {[number, number]} bounds @returns {[[number, number], boolean]} */
function shownRange(values, bounds) {
  const span = values[1] - values[0], kept = bounds.slice();
  if (span > 0) {
    kept[0] = Math.max(bounds[0], values[0] - 0.75 * span);
    kept[1] = Math.min(bounds[1], values[1] + 0.75 * span);
  }
  const margin = 0.04 * (kept[1] - kept[0]) || 0.5;
  const [low, high] = [kept[0] === 0 ? 0 : kept[0] - margin, kept[1] + margin];
  return [[low, high], low > bounds[0] || high < bounds[1]];
}

/** @param {string} label @param {number} size @returns {uPlot.Axis} */
function axis(label, size) {
  const lines = { stroke: () => colour("edge"), width: 0.7 };
  return { label, size, labelSize: 20, labelGap: 2, font, labelFont: font, grid: lines, ticks: lines,
    stroke: () => colour("soft"),
    values: (_, splits) => splits.map((v) => (v === null ? "" : String(Number(v.toPrecision(12))))) };
}

/** Bands below curves; thin lines through dots and bars, from end to end of the error.
 * @param {uPlot} plot @param {Series} s @param {string} paint @param {boolean} isBand */
function drawErrors(plot, s, paint, isBand) {
  const { ctx, bbox } = plot, error = s.error || [];
  const ends = Array.from(s.x, (v, i) => [v, ...[1, -1].map((sign) => s.y[i] + sign * (error[i] || 0))]
    .map((each, k) => plot.valToPos(each, k ? "y" : "x", true))).filter((each) => each.every(Number.isFinite));
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.beginPath();
  if (isBand) {
    ends.forEach(([x, high]) => ctx.lineTo(x, high));
    ends.reverse().forEach(([x, , low]) => ctx.lineTo(x, low));
    ctx.fillStyle = paint;
    ctx.globalAlpha = 0.22;
    ctx.fill();
  } else {
    for (const [x, high, low] of ends) {
      ctx.moveTo(x, high);
      ctx.lineTo(x, low);
    }
    ctx.strokeStyle = paint;
    ctx.globalAlpha = 0.6;
    ctx.lineWidth = devicePixelRatio;
    ctx.stroke();
  }
  ctx.restore();
}

/** A figure of series in one picture, as wide as its place.
 * @param {string} title @param {string} xLabel @param {string} yLabel @param {[number, number]} xs
 * @param {[[number, number], boolean]} shownOfY @param {Series[]} all @param {(s: Series) => uPlot.Series} style */
function plotted(title, xLabel, yLabel, xs, [ys, isCut], all, style) {
  const known = all.map((s) => Array.from(s.error || []).some((e) => e > 0)), isBar = style === asBars;
  const tables = all.map((s) => Array.from(s.x, (x, i) => /** @type {[number, number|null]} */ ([x,
    Number.isFinite(s.y[i]) ? s.y[i] : null])).sort((a, b) => a[0] - b[0]));
  const data = uPlot.join(tables.map((table) => [table.map((row) => row[0]), table.map((row) => row[1])]));
  const draw = (/** @type {boolean} */ bands) => (/** @type {uPlot} */ plot) => all.forEach((s, n) => {
    if (!known[n] || !plot.series[n + 1].show || bands !== !(isBar || s.dots)) return;
    drawErrors(plot, s, colour(isBar ? "ink" : `s${n % 4}`), bands);
    host.dataset.errors = bands ? "band" : "whiskers";
  });
  const host = make("div", { "class": "curves", "tabindex": 0, "role": "group", "aria-label": title });
  const plot = new uPlot({
    width, height,
    scales: { x: { time: false, range: (_, low, high) => (low === data[0][0] && high === data[0][data[0].length - 1]
      ? xs : [low, high]) }, y: { range: () => ys } },
    axes: [axis(xLabel, 30), axis(yLabel, 62)],
    series: [{ label: xLabel, value: (_, v) => (v === null ? say("curveHint") : shown(v)) },
      ...all.map((s, n) => ({ "label": s.name, "class": `s${n % 4}`, "stroke": () => colour(`s${n % 4}`), ...style(s),
        "dash": dashes[n % 4], "value": (/** @type {uPlot} */ u, /** @type {number|null} */ v,
          /** @type {number} */ _, /** @type {number|null} */ at) => {
          if (v === null || v === undefined || at === null) return "";
          const error = s.error && s.error.length ? s.error[Array.from(s.x).indexOf(u.data[0][at])] : null;
          return `${shown(v, error)}${error ? ` ± ${shownError(error)}` : ""}`;
        } }))],
    hooks: { drawAxes: [draw(true)], draw: [draw(false)] },
  }, data, host);
  plot.ctx.canvas.setAttribute("role", "img");
  plot.ctx.canvas.setAttribute("aria-label", title);
  host.querySelector(".u-legend").setAttribute("aria-live", "polite");
  host.addEventListener("keydown", (/** @type {KeyboardEvent} */ e) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
    if (!step) return;
    const at = plot.cursor.idx ?? (step > 0 ? -1 : data[0].length), x = data[0][at + step];
    if (x !== undefined) plot.setCursor({ left: plot.valToPos(x, "x"), top: plot.over.clientHeight / 2 });
    e.preventDefault();
  });
  host.plot = plot; // for scripts of the reader, and for tests
  onTheme(host, () => plot.redraw());
  new ResizeObserver(() => {
    if (host.clientWidth) plot.setSize({ width: host.clientWidth,
      height: Math.max(260, Math.round(host.clientWidth * height / width)) });
  }).observe(host);
  return make("figure", {}, make("figcaption", {}, title), host,
    isCut ? make("div", { class: "reading" }, say("bandCut")) : null);
}

/** @param {Series} s @returns {uPlot.Series} */
function asCurve(s) {
  const points = { show: Boolean(s.dots) || s.x.length < 30, size: 6, fill: (/** @type {uPlot} */ _,
    /** @type {number} */ n) => colour(`s${(n - 1) % 4}`) };
  return s.dots ? { width: 2, points, paths: () => null } : { width: 2, points };
}

/** @returns {uPlot.Series} */
function asBars() {
  return { width: 0, fill: () => colour("s0") + "a0", points: { show: false },
    paths: /** @type {NonNullable<typeof uPlot.paths.bars>} */ (uPlot.paths.bars)({ size: [0.6, 10, 2] }) };
}

/** @param {string} title @param {string} xLabel @param {string} yLabel @param {Series[]} series */
export function chart(title, xLabel, yLabel, series) {
  const all = series.filter((each) => each.x.length > 0);
  const bounds = all.flatMap((s) => [1, -1].map((sign) => Array.from(s.y, (v, i) => v + sign
    * ((s.error && s.error[i]) || 0))));
  const values = range(all.map((s) => s.y)), ends = range(bounds);
  if (values[0] > 0 && values[0] < 0.5 * values[1]) values[0] = ends[0] = 0;
  return plotted(title, xLabel, yLabel, widened(range(all.map((s) => s.x)), 0.01), shownRange(values, ends), all,
    asCurve);
}

/** Bars of what is never negative, one for each x, with their errors as thin lines where they are known.
 * @param {string} title @param {string} xLabel @param {string} yLabel @param {ArrayLike<number>} xs
 * @param {ArrayLike<number>} values @param {ArrayLike<number>} [errors]  empty or nothing: not known */
export function bars(title, xLabel, yLabel, xs, values, errors = []) {
  const high = Array.from(values, (v, i) => v + (errors[i] || 0));
  return plotted(title, xLabel, yLabel, widened(range([xs]), 0.03), shownRange(range([values, [0]]),
    range([high, [0]])), [{ name: yLabel, x: xs, y: values, error: errors }], asBars);
}

/** @param {[number, number]} ends @param {number} share @returns {[number, number]} */
function widened(ends, share) {
  const more = share * (ends[1] - ends[0]) || 0.5;
  return [ends[0] - more, ends[1] + more];
}
