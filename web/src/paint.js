// SPDX-License-Identifier: GPL-3.0-or-later
// Paints the teeth in mesh. Each tooth is drawn in its own frame, so that the numbers of a path stay small and the
// picture sharp at any zoom.

import { groupAt } from "./data.js";
import { colour, scaleColour } from "./dom.js";
import { turned } from "./motion.js";
import { paintForces, paintRuler, paintSweep } from "./overlay.js";

const samples = 13; // of a flank
const budget = 5; // ms a frame for colours that are not known yet

export class Painter {
  /** @param {import("./data.js").Drive} drive @param {import("./motion.js").Mesh} mesh */
  constructor(drive, mesh) {
    this.drive = drive;
    this.mesh = mesh;
    const summary = groupAt(drive.results.solve, "summary");
    const figure = (summary && summary.attributes) || {};
    this.seat = figure.tip_radius_mm; // radius that coordinates of the circular spline count from
    this.halfWall = figure.r_m_mm - figure.flexspline_inner_radius_mm;
    /** @type {Map<string, Path2D>} */
    this.paths = new Map();
    /** @type {Map<number, {gaps: Float64Array, least: number[], at: number[]}>} */
    this.rows = new Map();
    this.rowsOf = "";
    this.known = true;
    /** @type {Record<string, string>} */
    this.colour = {};
    this.colours();
  }

  colours() {
    const c = ["spline", "flexspline", "generator", "paper", "ink", "accent", "faint"];
    this.colour = Object.fromEntries(c.map((name) => [name, colour(name)]));
  }

  /** Gaps along both flanks at a place.
   * @param {number} slice @param {{key: number, space: number, generator: number}} place @param {number} turn */
  row(slice, { key, space, generator }, turn) {
    const known = this.rows.get(key);
    if (known) return known;
    const mesh = this.mesh;
    const row = { gaps: new Float64Array(2 * samples), least: [Infinity, Infinity], at: [0, 0] };
    mesh.flanks().forEach(([from, to], flank) => {
      for (let i = 0; i < samples; ++i) {
        const point = mesh.at(slice, Math.round(from + (to - from) * i / (samples - 1)));
        const gap = mesh.gap(point, slice, space, generator, turn);
        row.gaps[flank * samples + i] = gap;
        if (gap < row.least[flank]) {
          row.least[flank] = gap;
          row.at[flank] = i;
        }
      }
    });
    this.rows.set(key, row);
    return row;
  }

  /** A path of every n-th point, kept.
   * @param {string} name @param {number} step
   * @param {(step: number) => Path2D} build */
  path(name, step, build) {
    const key = `${name} ${step}`;
    let path = this.paths.get(key);
    if (!path) this.paths.set(key, path = build(step));
    return path;
  }

  /** The void of a tooth space below its outline, from (0, seat).
   * @param {number} slice @param {number} step */
  spacePath(slice, step) {
    return this.path("space" + slice, step, () => {
      const path = new Path2D(), l = this.mesh.landmarks, last = l[l.length - 1];
      for (let i = l[0]; ; i = Math.min(last, i + step)) {
        const p = this.mesh.at(slice, i);
        path.lineTo(p.x, p.y - this.seat);
        if (i === last) break;
      }
      const depth = -4 * this.drive.module;
      path.lineTo(this.mesh.at(slice, last).x, depth);
      path.lineTo(this.mesh.at(slice, l[0]).x, depth);
      path.closePath();
      return path;
    });
  }

  /** @param {number} step */
  toothPath(step) {
    return this.path("tooth", step, () => {
      const path = new Path2D(), t = this.mesh.tooth, last = t.length - 2, deeper = this.drive.module / 4;
      path.moveTo(t[0], t[1] - deeper); // into the rim: no seam
      for (let i = 0; ; i = Math.min(last, i + 2 * step)) {
        path.lineTo(t[i], t[i + 1]);
        if (i === last) break;
      }
      path.lineTo(t[last], t[last + 1] - deeper);
      return path;
    });
  }

  /**
   * @param {CanvasRenderingContext2D} ctx @param {import("./view.js").View} view
   * @param {{angle: number, slice: number, turn: number, held: number, limit: number, sweep: boolean, forces: boolean,
   *   ruler: {x: number, y: number}[]}} s
   */
  paint(ctx, view, s) {
    const { mesh, seat } = this, k = view.scale * view.dpr;
    const spin = s.held === 1 ? -s.angle : 0; // of the picture
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    ctx.fillStyle = this.colour.paper;
    ctx.fillRect(0, 0, ctx.canvas.width, ctx.canvas.height);
    /** Draws in a frame at (x, y) whose y axis leans clockwise.
     * @param {number} x @param {number} y @param {number} lean */
    const frame = (x, y, lean) => {
      const p = view.toPixels(x, y), c = Math.cos(lean) * k, n = Math.sin(lean) * k;
      ctx.setTransform(c, n, n, -c, p.x * view.dpr, p.y * view.dpr);
    };
    /** @param {number} r @param {string} fill */
    const disc = (r, fill) => {
      frame(0, 0, 0);
      ctx.beginPath();
      ctx.arc(0, 0, r, 0, 2 * Math.PI);
      ctx.fillStyle = fill;
      ctx.fill();
    };
    const margin = 3 * this.drive.module;
    /** @param {number} x @param {number} y */
    const isSeen = (x, y) => {
      const p = view.toPixels(x, y), more = margin * view.scale;
      return p.x > -more && p.x < view.width + more && p.y > -more && p.y < view.height + more;
    };
    const step = 2 ** Math.max(0, Math.floor(Math.log2(0.8 / (0.0015 * view.scale))));
    disc(mesh.reach + 4 * this.drive.module, this.colour.spline);
    disc(mesh.tip(s.slice), this.colour.paper);
    const space = this.spacePath(s.slice, Math.min(64, step));
    /** @type {number[]} */
    const seen = [];
    ctx.fillStyle = this.colour.paper;
    for (let i = 0; i < mesh.spaces; ++i) {
      const lean = i * mesh.pitch + spin, at = turned(0, seat, lean);
      if (!isSeen(at.x, at.y)) continue;
      seen.push(i);
      frame(at.x, at.y, lean);
      ctx.fill(space);
    }
    this.paintFlexspline(ctx, view, s, spin, frame, isSeen, this.toothPath(Math.min(64, step)));
    this.paintGaps(ctx, s, spin, seen, frame, view);
    if (s.sweep) paintSweep(this, ctx, s, spin, view, frame);
    if (s.forces) paintForces(this, ctx, s, spin, view);
    paintRuler(this, ctx, view, s.ruler);
  }

  /** @param {CanvasRenderingContext2D} ctx @param {import("./view.js").View} view @param {any} s @param {number} spin
   * @param {(x: number, y: number, lean: number) => void} frame @param {(x: number, y: number) => boolean} isSeen
   * @param {Path2D} tooth */
  paintFlexspline(ctx, view, s, spin, frame, isSeen, tooth) {
    const { mesh } = this, t = mesh.tooth, last = t.length - 2, by = s.angle + s.turn + spin;
    const ring = new Path2D(), inner = new Path2D();
    /** @type {import("./motion.js").Pose[]} */
    const seen = [];
    for (let i = 0; i < mesh.flexsplineTeeth; ++i) {
      const pose = mesh.pose(s.slice, mesh.phi(i, s.angle));
      const origin = turned(pose.x, pose.y, by), lean = pose.lean + by;
      if (isSeen(origin.x, origin.y)) seen.push({ ...origin, lean });
      /** @param {Path2D} path @param {number} x @param {number} y */
      const add = (path, x, y) => {
        const p = turned(x, y, lean), q = view.toPixels(origin.x + p.x, origin.y + p.y);
        path.lineTo(q.x * view.dpr, q.y * view.dpr);
      };
      add(ring, t[0], t[1]);
      add(ring, t[last], t[last + 1]);
      add(inner, 0, -this.halfWall);
    }
    ring.closePath();
    inner.closePath();
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    ctx.fillStyle = this.colour.flexspline;
    ctx.fill(ring);
    for (const at of seen) {
      frame(at.x, at.y, at.lean);
      ctx.fill(tooth);
    }
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    ctx.fillStyle = this.colour.generator;
    ctx.fill(inner);
    frame(0, 0, by);
    ctx.strokeStyle = this.colour.ink;
    ctx.lineWidth = 1.5 / view.scale;
    ctx.beginPath();
    const r = this.seat * 0.9;
    ctx.moveTo(0, -r);
    ctx.lineTo(0, r);
    ctx.moveTo(-0.03 * r, 0.93 * r);
    ctx.lineTo(0, r);
    ctx.lineTo(0.03 * r, 0.93 * r);
    ctx.stroke();
    ctx.beginPath();
    ctx.arc(0, 0, r / 6, 0, 2 * Math.PI);
    ctx.fillStyle = this.colour.paper;
    ctx.fill();
  }

  /** Flanks coloured by their gap, a dot where they touch.
   * @param {CanvasRenderingContext2D} ctx @param {any} s @param {number} spin @param {number[]} seen
   * @param {(x: number, y: number, lean: number) => void} frame @param {import("./view.js").View} view */
  paintGaps(ctx, s, spin, seen, frame, view) {
    const { mesh } = this, key = `${s.slice} ${s.turn}`, began = performance.now();
    if (this.rowsOf !== key) this.rows.clear();
    this.rowsOf = key;
    this.known = true;
    const fine = seen.length <= 40;
    ctx.lineCap = "round";
    ctx.lineWidth = (fine ? 3 : 2) / view.scale;
    for (const i of seen) {
      const place = mesh.place(i, s.angle);
      if (!this.rows.has(place.key) && performance.now() - began > budget) {
        this.known = false;
        continue;
      }
      const row = this.row(s.slice, place, s.turn);
      mesh.flanks().forEach(([from, to], flank) => {
        if (row.least[flank] > s.limit) return;
        const lean = i * mesh.pitch + spin, at = turned(0, this.seat, lean);
        frame(at.x, at.y, lean);
        /** @param {number} n */
        const point = (n) => mesh.at(s.slice, Math.round(from + (to - from) * n / (samples - 1)));
        const width = fine ? 1 : samples - 1, between = fine ? 6 : 1;
        for (let n = 0; n + width < samples; n += width) {
          const gap = fine ? (row.gaps[flank * samples + n] + row.gaps[flank * samples + n + 1]) / 2 : row.least[flank];
          if (gap > s.limit) continue;
          ctx.strokeStyle = scaleColour(gap < -this.mesh.gapError ? -1 : Math.max(0, gap) / s.limit);
          ctx.beginPath();
          for (let part = 0; part <= between; ++part) {
            const p = point(n + width * part / between);
            ctx.lineTo(p.x, p.y - this.seat);
          }
          ctx.stroke();
        }
        if (fine && row.least[flank] < 1e-3) {
          const p = point(row.at[flank]);
          ctx.fillStyle = this.colour.accent;
          ctx.beginPath();
          ctx.arc(p.x, p.y - this.seat, 4 / view.scale, 0, 2 * Math.PI);
          ctx.fill();
        }
      });
    }
  }
}
