// SPDX-License-Identifier: GPL-3.0-or-later
// The teeth as they turn: the program's own poses, interpolated (include/hdconj/turning_teeth.hpp).
// Angles clockwise from y, lengths in mm.

import { column, numbers } from "./data.js";

/** @typedef {{x: number, y: number}} Point */
/** @typedef {{x: number, y: number, lean: number}} Pose  origin and angle of the y axis */

/** The cubic through four even values; @p t in 0 ... 1 between the middle two.
 * @param {number} a @param {number} b @param {number} c @param {number} d @param {number} t */
function cubic(a, b, c, d, t) {
  return -a * t * (t - 1) * (t - 2) / 6 + b * (t + 1) * (t - 1) * (t - 2) / 2 - c * (t + 1) * t * (t - 2) / 2
    + d * (t + 1) * t * (t - 1) / 6;
}

/** The point turned clockwise.
 * @param {number} x @param {number} y @param {number} angle */
export function turned(x, y, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return { x: c * x + s * y, y: -s * x + c * y };
}

export class Mesh {
  /** @param {import("./data.js").Drive} drive */
  constructor(drive) {
    const teeth = /** @type {import("./data.js").Teeth} */ (drive.teeth);
    this.teeth = teeth;
    this.flexsplineTeeth = drive.flexspline_teeth;
    this.spaces = drive.circular_spline_teeth;
    this.pitch = 2 * Math.PI / this.spaces;
    this.z = teeth.z;
    this.radius = numbers(teeth.radius);
    this.advance = numbers(teeth.advance);
    this.lean = numbers(teeth.lean);
    this.tooth = numbers(teeth.tooth);
    const outline = drive.spline.datasets && drive.spline.datasets.outline;
    this.outline = numbers(outline);
    this.points = outline && outline.shape ? outline.shape[1] : 0;
    this.landmarks = column(drive.spline, "landmarks");
    /** Errors of a gap: both polygons, and the motion [mm]. */
    this.gapError = teeth.chord + teeth.interpolation_error + drive.outline_error;
    this.reach = 0;
    for (let i = 0; i < this.points; ++i)
      this.reach = Math.max(this.reach, Math.hypot(this.outline[2 * i], this.outline[2 * i + 1]));
  }

  /** Point @p i of the tooth space's outline in a slice.
   * @param {number} slice @param {number} i */
  at(slice, i) {
    const j = 2 * (slice * this.points + i);
    return { x: this.outline[j], y: this.outline[j + 1] };
  }

  /** Undeformed angle of the tooth in @p space.
   * @param {number} space @param {number} generator  its angle [rad] */
  phi(space, generator) {
    return (space * this.pitch - generator) * this.spaces / this.flexsplineTeeth;
  }

  /** Pose of the tooth with the undeformed angle @p phi in the frame of the wave generator.
   * @param {number} slice @param {number} phi @returns {Pose} */
  pose(slice, phi) {
    const n = this.teeth.steps, first = slice * n;
    const place = phi / this.teeth.period * n;
    const low = Math.floor(place), t = place - low;
    const index = [-1, 0, 1, 2].map((k) => first + (((low + k) % n) + n) % n);
    /** @param {ArrayLike<number>} of */
    const between = (of) => cubic(of[index[0]], of[index[1]], of[index[2]], of[index[3]], t);
    const origin = turned(0, between(this.radius), phi + between(this.advance));
    return { x: origin.x, y: origin.y, lean: phi + between(this.lean) };
  }

  /** The same in the frame of a tooth space, its centre line along y; the flexspline is turned by @p turn.
   * @param {number} slice @param {number} space @param {number} tooth  in the space of that number
   * @param {number} generator @param {number} turn @returns {Pose} */
  poseInSpace(slice, space, tooth, generator, turn) {
    const pose = this.pose(slice, this.phi(tooth, generator));
    const by = generator - space * this.pitch + turn;
    const origin = turned(pose.x, pose.y, by);
    return { x: origin.x, y: origin.y, lean: pose.lean + by };
  }

  /** Signed distance of a point in the frame of @p space to the nearest tooth; negative inside. Exact but for the
   * chords of the tooth's polygon.
   * @param {Point} point @param {number} slice @param {number} space
   * @param {number} generator @param {number} turn */
  gap(point, slice, space, generator, turn) {
    let least = Infinity;
    for (const tooth of [space - 1, space, space + 1]) {
      const pose = this.poseInSpace(slice, space, tooth, generator, turn);
      const p = turned(point.x - pose.x, point.y - pose.y, -pose.lean);
      least = Math.min(least, this.toTooth(p.x, p.y));
    }
    return least;
  }

  /** Signed distance of a point to the tooth in the tooth's own frame.
   * @param {number} px @param {number} py */
  toTooth(px, py) {
    const t = this.tooth;
    let least = Infinity, inside = false;
    let ax = t[0], ay = t[1];
    for (let i = 2; i < t.length; i += 2) {
      const bx = t[i], by = t[i + 1], dx = bx - ax, dy = by - ay;
      const share = Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy)));
      const ex = px - ax - share * dx, ey = py - ay - share * dy;
      least = Math.min(least, ex * ex + ey * ey);
      // the tooth is open at its root: below it all between the flanks is inside
      if ((ax <= px) !== (bx <= px) && py < ay + (px - ax) / dx * dy) inside = !inside;
      ax = bx;
      ay = by;
    }
    return inside ? -Math.sqrt(least) : Math.sqrt(least);
  }

  /** First and last point of both flanks of the outline.
   * @returns {[number, number][]} */
  flanks() {
    const l = this.landmarks;
    return [[l[0], l[1]], [l[l.length - 2], l[l.length - 1]]];
  }

  /** The smallest gap of the flanks of all spaces in a slice, and where.
   * @param {number} slice @param {number} generator @param {number} turn */
  smallest(slice, generator, turn) {
    const coarse = [];
    for (let space = 0; space < this.spaces; ++space)
      for (const [from, to] of this.flanks())
        for (let part = 0; part <= 8; ++part) {
          const i = Math.round(from + (to - from) * part / 8);
          coarse.push({ space, from, to, gap: this.roughGap(this.at(slice, i), slice, space, generator, turn) });
        }
    coarse.sort((a, b) => a.gap - b.gap);
    let best = { gap: Infinity, space: 0, point: { x: 0, y: 0 } };
    const seen = new Set();
    for (const { space, from, to } of coarse) {
      const key = space + ":" + from;
      if (seen.has(key)) continue;
      seen.add(key);
      if (seen.size > 12) break;
      for (let i = from; i <= to; ++i) {
        const point = this.at(slice, i);
        const gap = this.gap(point, slice, space, generator, turn);
        if (gap < best.gap) best = { gap, space, point };
      }
    }
    return best;
  }

  /** Distance to every 16th point of the space's own tooth.
   * @param {Point} point @param {number} slice
   * @param {number} space @param {number} generator @param {number} turn */
  roughGap(point, slice, space, generator, turn) {
    const pose = this.poseInSpace(slice, space, space, generator, turn);
    const p = turned(point.x - pose.x, point.y - pose.y, -pose.lean);
    let least = Infinity;
    for (let i = 0; i < this.tooth.length; i += 32)
      least = Math.min(least, Math.hypot(p.x - this.tooth[i], p.y - this.tooth[i + 1]));
    return least;
  }
}
