// SPDX-License-Identifier: GPL-3.0-or-later
// The teeth as they turn: the program's own poses, interpolated (include/hdconj/turning_teeth.hpp).
// Angles clockwise from y, lengths in mm.

import { column, numbers } from "./data.js";

/** @typedef {{x: number, y: number}} Point */
/** @typedef {{x: number, y: number, lean: number}} Pose  origin and angle of the y axis */

const tableSteps = 2048; // of the places of one wave whose gaps are kept

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
  /** @param {import("./data.js").Drive} drive @param {import("./data.js").Group} [spline] */
  constructor(drive, spline = drive.spline) {
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
    const outline = spline.datasets && spline.datasets.outline;
    this.outline = numbers(outline);
    this.points = outline && outline.shape ? outline.shape[1] : 0;
    this.landmarks = column(spline, "landmarks");
    this.reach = 0;
    for (let i = 0; i < this.points; ++i)
      this.reach = Math.max(this.reach, Math.hypot(this.outline[2 * i], this.outline[2 * i + 1]));
    /** Errors of a gap: both polygons, the motion, and numbers in single precision [mm]. */
    this.gapError = teeth.chord + teeth.interpolation_error + drive.outline_error
      + (outline && outline.type === "f4" ? this.reach * 2 ** -24 : 0);
  }

  /** Point @p i of the tooth space's outline in a slice; on the chord between two where @p i is no whole number.
   * @param {number} slice @param {number} i */
  at(slice, i) {
    const whole = Math.floor(i), share = i - whole, j = 2 * (slice * this.points + whole), o = this.outline;
    if (share === 0) return { x: o[j], y: o[j + 1] };
    return { x: o[j] + share * (o[j + 2] - o[j]), y: o[j + 1] + share * (o[j + 3] - o[j + 1]) };
  }

  /** Radius of the tip circle in a slice.
   * @param {number} slice */
  tip(slice) {
    const land = this.at(slice, this.landmarks[0]);
    return Math.hypot(land.x, land.y);
  }

  /** Undeformed angle of the flexspline's tooth @p number.
   * @param {number} number @param {number} generator  its angle [rad] */
  phi(number, generator) {
    return 2 * Math.PI * number / this.flexsplineTeeth - generator * this.spaces / this.flexsplineTeeth;
  }

  /** Undeformed angle of the tooth that stands in @p space: counted from the nearest lobe of the wave generator, since
   * from lobe to lobe the teeth stand in other spaces.
   * @param {number} space @param {number} generator */
  phiIn(space, generator) {
    const angle = space * this.pitch - generator, { period } = this.teeth;
    const lobe = period * Math.round(angle / period);
    return lobe + (angle - lobe) * this.spaces / this.flexsplineTeeth;
  }

  /** A place whose gaps are those of @p space, and the number that it is known by: tooth after tooth goes through the
   * same.
   * @param {number} space @param {number} generator */
  place(space, generator) {
    const { period } = this.teeth, phi = this.phiIn(space, generator);
    const key = Math.round((phi / period - Math.round(phi / period)) * tableSteps);
    return { key, space: 0, generator: -key * period / tableSteps * this.flexsplineTeeth / this.spaces };
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
   * @param {number} slice @param {number} space @param {number} beside  0: the tooth in that space, 1: the next one
   * @param {number} generator @param {number} turn @returns {Pose} */
  poseInSpace(slice, space, beside, generator, turn) {
    const pose = this.pose(slice, this.phiIn(space, generator) + 2 * Math.PI * beside / this.flexsplineTeeth);
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
    for (const beside of [-1, 0, 1]) {
      const pose = this.poseInSpace(slice, space, beside, generator, turn);
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

  /** The least of @p gap between two points of an outline, which has one minimum there.
   * @param {(i: number) => number} gap @param {number} from @param {number} to */
  leastBetween(gap, from, to) {
    const steps = 24; // of a third each: a chord's 1e-4
    for (let step = 0; step < steps; ++step) {
      const third = (to - from) / 3;
      if (gap(from + third) < gap(to - third)) to -= third;
      else from += third;
    }
    return (from + to) / 2;
  }

  /** The smallest gap of the flanks of all spaces in a slice, and where: the least of some points of each flank and
   * what lies about it, chords included, where that is among the least of all.
   * @param {number} slice @param {number} generator @param {number} turn */
  smallest(slice, generator, turn) {
    const parts = 16, most = 24;
    /** @type {{space: number, gap: number, from: number, to: number}[]} */
    const found = [];
    for (let space = 0; space < this.spaces; ++space) {
      const pose = this.poseInSpace(slice, space, 0, generator, turn);
      for (const [from, to] of this.flanks()) {
        const index = (/** @type {number} */ part) => Math.round(from + (to - from) * part / parts);
        const gaps = Array.from({ length: parts + 1 }, (_, part) => {
          const at = this.at(slice, index(part)), p = turned(at.x - pose.x, at.y - pose.y, -pose.lean);
          return this.toTooth(p.x, p.y);
        });
        gaps.forEach((gap, part) => {
          if (gap <= (gaps[part - 1] ?? Infinity) && gap <= (gaps[part + 1] ?? Infinity))
            found.push({ space, gap, from: index(Math.max(0, part - 1)), to: index(Math.min(parts, part + 1)) });
        });
      }
    }
    found.sort((a, b) => a.gap - b.gap);
    let best = { gap: Infinity, space: 0, point: { x: 0, y: 0 } };
    for (const { space, from, to } of found.slice(0, most)) {
      const gap = (/** @type {number} */ i) => this.gap(this.at(slice, i), slice, space, generator, turn);
      const gaps = Array.from({ length: to - from + 1 }, (_, k) => gap(from + k));
      const middle = from + gaps.indexOf(Math.min(...gaps));
      for (const i of [middle, this.leastBetween(gap, Math.max(from, middle - 1), middle),
        this.leastBetween(gap, middle, Math.min(to, middle + 1))]) {
        const least = gap(i);
        if (least < best.gap) best = { gap: least, space, point: this.at(slice, i) };
      }
    }
    return best;
  }
}
