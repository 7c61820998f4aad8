// SPDX-License-Identifier: GPL-3.0-or-later
// Elements, the state in the URL's hash, colours.

/**
 * An element. Texts become text nodes, never markup.
 * @param {string} tag @param {Record<string, any>} [attributes]  functions are listeners
 * @param {...(Node|string|null|undefined)} children
 * @returns {any}
 */
export function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  set(element, attributes || {});
  for (const child of children) if (child !== null && child !== undefined) element.append(child);
  return element;
}

/** The same in SVG.
 * @param {string} tag @param {Record<string, any>} [attributes] @param {...(Node|string)} children
 * @returns {any} */
export function svg(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  set(element, attributes || {});
  element.append(...children);
  return element;
}

/** @param {Element} element @param {Record<string, any>} attributes */
function set(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== undefined) element.setAttribute(name, String(value));
  }
}

/** A choice with its label.
 * @param {string} label @param {string[]} options @param {number} chosen
 * @param {(index: number) => void} act */
export function choice(label, options, chosen, act) {
  const select = make("select", { change: () => act(select.selectedIndex) },
    ...options.map((text, i) => make("option", { selected: i === chosen }, text)));
  return make("label", {}, label + " ", select);
}

/** A button that is pressed or not.
 * @param {string} label @param {boolean} on @param {(on: boolean) => void} act */
export function toggle(label, on, act) {
  const button = make("button", { "type": "button", "aria-pressed": on, "click": () => {
    const next = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(next));
    act(next);
  } }, label);
  button.setAttribute("aria-pressed", String(on));
  return button;
}

/** What the hash says. @type {Map<string, string>} */
const state = new Map(new URLSearchParams(location.hash.slice(1)));
let written = 0;

/** @param {string} key @param {number} otherwise */
export function remembered(key, otherwise) {
  const value = Number(state.get(key));
  return state.has(key) && Number.isFinite(value) ? value : otherwise;
}

/** Keeps a number in the hash.
 * @param {string} key @param {number} value */
export function remember(key, value) {
  state.set(key, String(Number(value.toPrecision(8))));
  clearTimeout(written);
  written = window.setTimeout(() => history.replaceState(null, "", "#" + new URLSearchParams([...state])), 150);
}

/** The value of a colour of style.css.
 * @param {string} name */
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

/** Draws again when light becomes dark, for as long as the element is on the page.
 * @param {Element} element @param {() => void} draw */
export function onTheme(element, draw) {
  document.addEventListener("themechange", function again() {
    if (element.isConnected) draw();
    else document.removeEventListener("themechange", again);
  });
}

const cividis = [[0, 32, 77], [49, 68, 107], [102, 105, 112], [149, 144, 120], [203, 186, 105], [255, 234, 70]];

/** Cividis, readable with any colour vision: 0 stands out most, 1 least.
 * @param {number} share  below 0: interference, vermilion */
export function scaleColour(share) {
  if (!(share >= 0)) return "#d55e00";
  const dark = document.documentElement.dataset.theme === "dark";
  const within = Math.min(1, share);
  const x = (dark ? 1 - within : within) * (cividis.length - 1);
  const at = Math.min(cividis.length - 2, Math.floor(x));
  const mixed = cividis[at].map((c, i) => Math.round(c + (cividis[at + 1][i] - c) * (x - at)));
  return `rgb(${mixed.join(",")})`;
}

/** A bar that says what the colours mean.
 * @param {string} from @param {string} to @param {boolean} [reversed] */
export function legend(from, to, reversed) {
  const steps = Array.from({ length: 11 }, (_, i) => scaleColour(reversed ? 1 - i / 10 : i / 10));
  const bar = make("span", { class: "bar" });
  bar.style.background = `linear-gradient(90deg, ${steps.join(",")})`;
  return make("span", { class: "legend" }, from + " ", bar, " " + to);
}
