// SPDX-License-Identifier: GPL-3.0-or-later
// The path of the wire over the part, and the places that no pass reaches.

import { column, groupAt } from "./data.js";
import { choice, colour, make, onTheme } from "./dom.js";
import { say } from "./texts.js";
import { View } from "./view.js";

/** @param {import("./data.js").Drive} drive */
export function cuttingView(drive) {
  const wedm = drive.results.wedm;
  if (!wedm) return null;
  const setUps = Object.entries(wedm.groups || {}).filter(([name]) => name.startsWith("set_up_"));
  let setUp = 0, face = 0, pass = 0;
  const canvas = make("canvas", { "class": "mesh", "tabindex": 0, "role": "img", "aria-label": say("path") });
  const ctx = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const nominal = column(setUps[0][1], "lower");
  const radius = nominal.reduce((most, v) => Math.max(most, Math.abs(v)), 0);
  const view = new View(canvas, "c", { x: 0, y: 0, span: 2.2 * radius }, () => requestAnimationFrame(draw));
  const setUpOf = (/** @type {import("./data.js").Residual} */ spot) =>
    setUps.findIndex(([name]) => name === `set_up_${spot.set_up}`);
  const passes = () => Object.keys(setUps[setUp][1].groups || {}).filter((name) => name.startsWith("pass_"));

  /** @param {ArrayLike<number>} points @param {string} stroke @param {number} width @param {boolean} closed */
  function line(points, stroke, width, closed) {
    ctx.strokeStyle = stroke;
    ctx.lineWidth = width;
    ctx.beginPath();
    for (let i = 0; i < points.length; i += 2) {
      const p = view.toPixels(points[i], points[i + 1]);
      ctx.lineTo(p.x, p.y);
    }
    if (closed) ctx.closePath();
    ctx.stroke();
  }
  function draw() {
    const group = setUps[setUp][1], name = face === 0 ? "lower" : "upper";
    ctx.setTransform(view.dpr, 0, 0, view.dpr, 0, 0);
    ctx.fillStyle = colour("paper");
    ctx.fillRect(0, 0, view.width, view.height);
    line(column(group, name), colour("ink"), 1.2, true);
    passes().forEach((each, i) => {
      if (pass === 0 || pass === i + 1) line(column(groupAt(group, each), name), colour("s" + (i % 4)), 1.2, false);
    });
    ctx.fillStyle = colour("accent");
    for (const spot of view.span < 20 * drive.module ? drive.residuals : []) {
      if (spot.upper !== (face === 1) || setUpOf(spot) !== setUp) continue;
      const p = view.toPixels(spot.x, spot.y);
      ctx.fillRect(p.x - 3, p.y - 3, 6, 6);
    }
  }
  const setUpChoice = choice("", setUps.map(([name]) => name), 0, (i) => {
    setUp = i;
    draw();
  });
  const faceChoice = choice(say("face"), [say("lower"), say("upper")], 0, (i) => {
    face = i;
    draw();
  });
  onTheme(canvas, draw);
  canvas.addEventListener("keydown", (/** @type {KeyboardEvent} */ e) => {
    const step = view.span / 10;
    const act = { "+": () => view.zoom(1.4), "-": () => view.zoom(1 / 1.4), "0": () => view.showAll(),
      "ArrowLeft": () => view.show(view.x - step, view.y, view.span), "ArrowRight": () => view.show(view.x + step,
        view.y, view.span),
      "ArrowUp": () => view.show(view.x, view.y + step, view.span), "ArrowDown": () => view.show(view.x,
        view.y - step, view.span) }[e.key];
    if (!act) return;
    e.preventDefault();
    act();
  });
  /** Spots that differ in the tooth space alone are one line.
   * @type {Map<string, {spot: import("./data.js").Residual, count: number}>} */
  const spots = new Map();
  for (const spot of [...drive.residuals].sort((a, b) => b.height - a.height)) {
    const height = Number((spot.height * 1000).toPrecision(3));
    const text = `${height} um ${say("on")} ${say(spot.meshing ? "flank" : "root")}, ${
      say("pass")} ${spot.pass}, ${say(spot.upper ? "upper" : "lower")}`;
    const known = spots.get(text);
    if (known) ++known.count;
    else spots.set(text, { spot, count: 1 });
  }
  const list = spots.size ? make("ol", {}, ...[...spots].slice(0, 40).map(([text, { spot, count }]) => make("li", {},
    `${text}: ${count} ${say("places")}, ${say("tooth")} ${spot.tooth} `,
    make("button", { type: "button", click: () => {
      setUp = setUpOf(spot);
      face = spot.upper ? 1 : 0;
      setUpChoice.querySelector("select").selectedIndex = setUp;
      faceChoice.querySelector("select").selectedIndex = face;
      view.show(spot.x, spot.y, 2 * drive.module);
    } }, say("jump"))))) : make("p", {}, say("noResiduals"));
  const names = passes();
  return make("div", {}, make("div", { class: "controls" },
    setUps.length > 1 ? setUpChoice : null, faceChoice,
    choice(say("pass"), [say("allPasses"), ...names.map((_, i) => String(i + 1))], 0, (i) => {
      pass = i;
      draw();
    }),
    make("button", { type: "button", click: () => view.showAll() }, say("wholePart"))), canvas,
  make("div", { class: "names" }, make("span", { class: "key" }, say("nominal")),
    ...names.map((_, i) => make("span", { class: `key s${i % 4}` }, `${say("pass")} ${i + 1}`))),
  make("h3", {}, say("residuals")), list);
}
