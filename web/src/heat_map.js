// SPDX-License-Identifier: GPL-3.0-or-later
// Maps of coloured cells under axes, in SVG: they print sharp and can be read by a pointer.

import { make, onTheme, scaleColour, svg } from "./dom.js";
import { shown } from "./data.js";
import { say } from "./texts.js";

const width = 520, height = 300, left = 64, right = 12, top = 12, bottom = 44;
const near = 3; // a pointer so far outside reads what is at the border

/** Round numbers that cover an interval.
 * @param {number} low @param {number} high @param {number} [count] */
function ticks(low, high, count = 6) {
  const raw = (high - low) / count || 1, power = 10 ** Math.floor(Math.log10(raw));
  const step = ([1, 2, 5, 10].find((d) => d * power >= raw) || 10) * power;
  const all = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
    all.push(Number((i * step).toPrecision(12)));
  return all;
}

/** @param {number} low @param {number} high @param {number} from @param {number} to */
function scale(low, high, from, to) {
  const span = high - low || 1;
  return (/** @type {number} */ v) => from + (v - low) / span * (to - from);
}

/** @param {number} v @param {number[]} ends */
function within(v, ends) {
  return Math.min(ends[1], Math.max(ends[0], v));
}

/** Borders of cells about @p at, half way between neighbours. The outer cells end at their places, around a ring half a
 * step further; one alone is 1 wide.
 * @param {number[]} at @param {boolean} [isRing] */
function bordersOf(at, isRing) {
  const half = at.length < 2 ? 0.5 : isRing ? (at[1] - at[0]) / 2 : 0;
  return [at[0] - half, ...at.slice(1).map((v, i) => (at[i] + v) / 2), at[at.length - 1] + half];
}

/** Number of the cell in which @p v lies.
 * @param {number[]} borders @param {number} v */
function cellAt(borders, v) {
  return borders.findIndex((border, i) => i > 0 && v <= border) - 1;
}

/** Axes with their ticks and labels.
 * @param {(v: number) => number} x @param {(v: number) => number} y @param {number[]} xs @param {number[]} ys
 * @param {string} xLabel @param {string} yLabel */
function axes(x, y, xs, ys, xLabel, yLabel) {
  const group = svg("g", { class: "axes" });
  for (const v of ticks(xs[0], xs[1]))
    group.append(svg("line", { x1: x(v), x2: x(v), y1: top, y2: height - bottom }),
      svg("text", { x: x(v), y: height - bottom + 16, "text-anchor": "middle" }, String(v)));
  for (const v of ticks(ys[0], ys[1], 5))
    group.append(svg("line", { x1: left, x2: width - right, y1: y(v), y2: y(v) }),
      svg("text", { x: left - 6, y: y(v) + 4, "text-anchor": "end" }, String(v)));
  group.append(svg("text", { class: "label", x: (left + width - right) / 2, y: height - 6,
    "text-anchor": "middle" }, xLabel),
    svg("text", { class: "label", x: 14, y: (top + height - bottom) / 2, "text-anchor": "middle",
      transform: `rotate(-90 14 ${(top + height - bottom) / 2})` }, yLabel));
  return group;
}

/** Acts where a pointer moves or a finger taps.
 * @param {Element} picture @param {(e: PointerEvent) => void} act */
function onPoint(picture, act) {
  for (const type of ["pointermove", "pointerdown"])
    picture.addEventListener(type, (e) => act(/** @type {PointerEvent} */ (e)));
}

/** A figure around a picture, with the reading at the pointer.
 * @param {string} title @param {Element} picture
 * @param {HTMLElement} reading @param {...(Node|string)} more */
function framed(title, picture, reading, ...more) {
  return make("figure", {}, make("figcaption", {}, title), picture, reading, ...more);
}

/**
 * A map of cells, value(i, j) at xs[i], ys[j], painted on a canvas under axes.
 * @param {string} title @param {string} xLabel @param {string} yLabel @param {ArrayLike<number>} xs
 * @param {ArrayLike<number>} ys @param {(i: number, j: number) => number} value
 * @param {(v: number) => string} paint @param {Node} key  what the colours mean
 * @param {{read?: (x: number, y: number) => string,
 *   over?: (x: (v: number) => number, y: (v: number) => number) => Element, isRing?: boolean}} [more]  the text at the
 *   pointer, of the values there, what is drawn over the cells, and whether the places of x follow each other around
 *   the ring
 */
export function heatMap(title, xLabel, yLabel, xs, ys, value, paint, key, more = {}) {
  const bx = bordersOf(Array.from(xs), more.isRing), by = bordersOf(Array.from(ys));
  const wx = [bx[0], bx[xs.length]], wy = [by[0], by[ys.length]];
  const x = scale(wx[0], wx[1], left, width - right), y = scale(wy[0], wy[1], height - bottom, top);
  const picture = svg("svg", { "viewBox": `0 0 ${width} ${height}`, "class": "chart", "role": "img",
    "aria-label": title });
  const cells = svg("g", { "shape-rendering": "crispEdges" });
  const redraw = () => {
    cells.replaceChildren();
    /** @type {Map<string, string>} */
    const paths = new Map(); // one path a colour: some hundred, not some thousand elements
    for (let i = 0; i < xs.length; ++i)
      for (let j = 0; j < ys.length; ++j) {
        const v = value(i, j);
        if (!Number.isFinite(v)) continue;
        const colour = paint(v), a = x(bx[i]), b = x(bx[i + 1]), c = y(by[j]), d = y(by[j + 1]);
        const box = `M${a.toFixed(1)} ${c.toFixed(1)}H${(b + 0.3).toFixed(1)}V${d.toFixed(1)}H${a.toFixed(1)}Z`;
        paths.set(colour, (paths.get(colour) || "") + box);
      }
    for (const [fill, d] of paths) cells.append(svg("path", { fill, d }));
  };
  redraw();
  onTheme(picture, redraw);
  picture.append(cells, axes(x, y, wx, wy, xLabel, yLabel), ...(more.over ? [more.over(x, y)] : []));
  const reading = make("div", { class: "reading" }, say("hoverHint"));
  onPoint(picture, (e) => {
    const box = picture.getBoundingClientRect();
    const px = (e.clientX - box.left) / box.width * width, py = (e.clientY - box.top) / box.height * height;
    if (px < left - near || px > width - right + near || py < top - near || py > height - bottom + near) return;
    const vx = within(wx[0] + (px - left) / (width - right - left) * (wx[1] - wx[0]), wx);
    const vy = within(wy[1] - (py - top) / (height - bottom - top) * (wy[1] - wy[0]), wy);
    const i = cellAt(bx, vx), j = cellAt(by, vy);
    reading.textContent = more.read ? more.read(vx, vy)
      : `${shown(xs[i])}, ${shown(ys[j])}: ${shown(value(i, j))}`;
  });
  return { figure: framed(title, picture, reading, key), redraw };
}

/** Shades of @p share 0 ... 1 where much stands out.
 * @param {number} share */
export function strong(share) {
  return scaleColour(1 - Math.min(1, Math.max(0, share)));
}
