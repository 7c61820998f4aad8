// SPDX-License-Identifier: GPL-3.0-or-later
// A canvas that one drags, zooms and pinches: from millimetres, y upward, to pixels.

import { remember, remembered } from "./dom.js";

export class View {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {string} key  under which the hash remembers it
   * @param {{x: number, y: number, span: number}} whole  centre and width of everything [mm]
   * @param {() => void} changed
   */
  constructor(canvas, key, whole, changed) {
    this.canvas = canvas;
    this.key = key;
    this.whole = whole;
    this.changed = changed;
    this.width = this.height = this.dpr = 1;
    const kept = Math.abs(remembered(key + "s", whole.span) / whole.span - 1) < 0.01 ? remembered // of a drive as large
      : (/** @type {string} */ _, /** @type {number} */ otherwise) => otherwise;
    this.x = kept(key + "x", whole.x);
    this.y = kept(key + "y", whole.y);
    this.span = kept(key + "w", whole.span);
    /** Takes a drag that is not to move the picture; told the point in mm and "start", "move" or "end".
     * @type {((x: number, y: number, what: string) => boolean)|null} */
    this.onDrag = null;
    /** @type {((x: number, y: number) => void)|null} */
    this.onHover = null;
    /** @type {Map<number, {x: number, y: number}>} */
    this.pointers = new Map();
    this.taken = false;
    canvas.addEventListener("pointerdown", (e) => this.down(e));
    canvas.addEventListener("pointermove", (e) => this.move(e));
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, (e) => this.up(/** @type {PointerEvent} */ (e)));
    canvas.addEventListener("wheel", (e) => {
      if (!e.ctrlKey && document.activeElement !== canvas) return; // who scrolls past is not held up
      e.preventDefault();
      this.zoom(Math.exp(-e.deltaY * 0.002), e.offsetX, e.offsetY);
    }, { passive: false });
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  /** Pixels per mm. */
  get scale() {
    return Math.min(this.width, this.height) / this.span;
  }

  resize() {
    this.width = this.canvas.clientWidth || 1;
    this.height = this.canvas.clientHeight || 1;
    this.dpr = Math.min(2, window.devicePixelRatio || 1);
    this.canvas.width = Math.round(this.width * this.dpr);
    this.canvas.height = Math.round(this.height * this.dpr);
    this.changed();
  }

  /** @param {number} x @param {number} y  in mm; @returns pixels of CSS */
  toPixels(x, y) {
    return { x: this.width / 2 + (x - this.x) * this.scale, y: this.height / 2 - (y - this.y) * this.scale };
  }

  /** @param {number} px @param {number} py */
  toMillimetres(px, py) {
    return { x: this.x + (px - this.width / 2) / this.scale, y: this.y - (py - this.height / 2) / this.scale };
  }

  /** @param {number} x @param {number} y @param {number} span */
  show(x, y, span) {
    this.x = x;
    this.y = y;
    this.span = Math.max(2e-4, Math.min(2 * this.whole.span, span));
    remember(this.key + "x", this.x);
    remember(this.key + "y", this.y);
    remember(this.key + "w", this.span);
    remember(this.key + "s", this.whole.span);
    this.changed();
  }

  showAll() {
    this.show(this.whole.x, this.whole.y, this.whole.span);
  }

  /** Zooms about a pixel.
   * @param {number} factor @param {number} [px] @param {number} [py] */
  zoom(factor, px = this.width / 2, py = this.height / 2) {
    const fixed = this.toMillimetres(px, py);
    const span = Math.max(2e-4, Math.min(2 * this.whole.span, this.span / factor));
    const grown = span / this.span;
    this.show(fixed.x + (this.x - fixed.x) * grown, fixed.y + (this.y - fixed.y) * grown, span);
  }

  /** @param {PointerEvent} e */
  down(e) {
    this.canvas.setPointerCapture(e.pointerId);
    this.pointers.set(e.pointerId, { x: e.offsetX, y: e.offsetY });
    const at = this.toMillimetres(e.offsetX, e.offsetY);
    this.taken = this.pointers.size === 1 && this.onDrag !== null && this.onDrag(at.x, at.y, "start");
  }

  /** @param {PointerEvent} e */
  move(e) {
    const at = this.toMillimetres(e.offsetX, e.offsetY);
    const before = this.pointers.get(e.pointerId);
    if (this.onHover) this.onHover(at.x, at.y);
    if (!before) return;
    const now = { x: e.offsetX, y: e.offsetY };
    if (this.pointers.size === 2) {
      const other = [...this.pointers].filter(([id]) => id !== e.pointerId)[0][1];
      const was = Math.hypot(before.x - other.x, before.y - other.y);
      const is = Math.hypot(now.x - other.x, now.y - other.y);
      if (was > 0 && is > 0) this.zoom(is / was, (now.x + other.x) / 2, (now.y + other.y) / 2);
    } else if (this.taken && this.onDrag) {
      this.onDrag(at.x, at.y, "move");
    } else {
      this.show(this.x - (now.x - before.x) / this.scale, this.y + (now.y - before.y) / this.scale, this.span);
    }
    this.pointers.set(e.pointerId, now);
  }

  /** @param {PointerEvent} e */
  up(e) {
    const at = this.toMillimetres(e.offsetX, e.offsetY);
    if (this.taken && this.onDrag) this.onDrag(at.x, at.y, "end");
    this.taken = false;
    this.pointers.delete(e.pointerId);
  }
}
