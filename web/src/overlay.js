// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn over the teeth when it is asked for: conjugate branches, forces, the ruler.

import { column, groupAt, roundLength } from "./data.js";
import { turned } from "./motion.js";

/** The conjugate branches and the tooth in many places, in the space nearest to the middle of the picture.
 * @param {import("./paint.js").Painter} painter @param {CanvasRenderingContext2D} ctx @param {any} s
 * @param {number} spin @param {import("./view.js").View} view
 * @param {(x: number, y: number, lean: number) => void} frame */
export function paintSweep(painter, ctx, s, spin, view, frame) {
  const { mesh } = painter;
  const space = Math.round((Math.atan2(view.x, view.y) - spin) / mesh.pitch);
  const lean = space * mesh.pitch + spin, tooth = painter.toothPath(4), base = turned(0, painter.seat, lean);
  ctx.lineWidth = 0.7 / view.scale;
  ctx.strokeStyle = painter.colour.faint;
  for (let i = -30; i <= 30; ++i) {
    const generator = space * mesh.pitch + i / 30 * Math.PI / 3;
    const pose = mesh.poseInSpace(s.slice, space, 0, generator, s.turn);
    const at = turned(pose.x, pose.y, lean);
    frame(at.x, at.y, pose.lean + lean);
    ctx.stroke(tooth);
  }
  const envelope = groupAt(painter.drive.results.solve, "envelope");
  ctx.strokeStyle = painter.colour.accent;
  ctx.lineWidth = 1.6 / view.scale;
  for (const branch of Object.values((envelope && envelope.groups) || {})) {
    const point = column(branch, "point");
    frame(base.x, base.y, lean);
    ctx.beginPath();
    for (let i = 0; i < point.length; i += 2) ctx.lineTo(point[i], point[i + 1] - painter.seat);
    ctx.stroke();
  }
}

/** Forces of the loaded teeth: of one slice where the loaded teeth are drawn, else of all slices.
 * @param {import("./paint.js").Painter} painter @param {CanvasRenderingContext2D} ctx @param {any} s
 * @param {number} spin @param {import("./view.js").View} view */
export function paintForces(painter, ctx, s, spin, view) {
  const load = groupAt(painter.drive.results.load, "load");
  const shown = groupAt(load, "case_" + String((load && load.attributes && load.attributes.written_case)
    || 0).padStart(3, "0"));
  const contacts = groupAt(shown, "contacts"), angle = column(groupAt(shown, "map"), "angle");
  const force = column(contacts, "force"), space = column(contacts, "space");
  const slice = column(contacts, "slice");
  const place = column(contacts, "place"), normal = column(contacts, "normal"), half = column(contacts, "half_width");
  const sectors = (load && load.attributes && load.attributes.sectors) || 1;
  const largest = force.reduce((a, b) => Math.max(a, b), 0);
  ctx.setTransform(view.dpr, 0, 0, view.dpr, 0, 0);
  ctx.strokeStyle = painter.colour.accent;
  ctx.lineWidth = 2;
  for (let sector = 0; sector < sectors; ++sector)
    for (let i = 0; i < force.length; ++i) {
      if (s.loaded && slice[i] !== s.slice) continue;
      const lean = angle[space[i]] + s.angle + 2 * Math.PI * sector / sectors + spin;
      const p = turned(place[2 * i], place[2 * i + 1], lean), n = turned(normal[2 * i], normal[2 * i + 1], lean);
      const a = view.toPixels(p.x, p.y), length = 4 + Math.min(56, view.height / 10) * force[i] / largest;
      const strip = half[i] * view.scale; // as wide as Hertz says, along the flank
      ctx.beginPath();
      ctx.moveTo(a.x, a.y);
      ctx.lineTo(a.x + n.x * length, a.y - n.y * length);
      ctx.moveTo(a.x + n.y * strip, a.y + n.x * strip);
      ctx.lineTo(a.x - n.y * strip, a.y - n.x * strip);
      ctx.stroke();
    }
}

/** A bar of round length, and what the ruler measures.
 * @param {import("./paint.js").Painter} painter @param {CanvasRenderingContext2D} ctx
 * @param {import("./view.js").View} view @param {{x: number, y: number}[]} ends */
export function paintRuler(painter, ctx, view, ends) {
  ctx.setTransform(view.dpr, 0, 0, view.dpr, 0, 0);
  ctx.strokeStyle = ctx.fillStyle = painter.colour.ink;
  ctx.lineWidth = 2;
  ctx.font = "13px system-ui, sans-serif";
  const length = roundLength(120 / view.scale), y = view.height - 14;
  ctx.beginPath();
  ctx.moveTo(14, y - 5);
  ctx.lineTo(14, y);
  ctx.lineTo(14 + length * view.scale, y);
  ctx.lineTo(14 + length * view.scale, y - 5);
  ctx.stroke();
  const text = length >= 1 ? `${length} mm` : `${Number((length * 1000).toPrecision(1))} um`;
  ctx.fillText(text, 14, y - 9);
  if (ends.length < 2) return;
  const [a, b] = ends.map((end) => view.toPixels(end.x, end.y));
  ctx.strokeStyle = ctx.fillStyle = painter.colour.accent;
  ctx.beginPath();
  ctx.moveTo(a.x, a.y);
  ctx.lineTo(b.x, b.y);
  ctx.stroke();
  const um = Math.hypot(ends[0].x - ends[1].x, ends[0].y - ends[1].y) * 1000;
  ctx.fillText(`${um.toFixed(um < 100 ? 2 : 1)} um`, (a.x + b.x) / 2 + 8, (a.y + b.y) / 2 - 8);
}
