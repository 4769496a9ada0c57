/** Finding and making elements. */

/** The element with this id, which the page is known to have. */
export function byId<Type extends HTMLElement>(id: string): Type {
  const element = document.getElementById(id);
  if (!element) throw new Error(`the page has no element ${id}`);
  return element as Type;
}

export function make<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Readonly<Record<string, string>> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** Sets a text, where it is another, in the text node that is there: that costs the least layout. */
export function setText(element: Element, text: string): void {
  const node = element.firstChild;
  if (!(node instanceof Text) || node.nextSibling) element.textContent = text;
  else if (node.data !== text) node.data = text;
}

/** Sets an attribute, where it is another. */
export function setAttribute(element: Element, name: string, value: string): void {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** Sets the value of a control, where it is another. */
export function setValue(control: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (control.value !== value) control.value = value;
}

/** A short sample of a line. */
export function lineSample(stroke: { color: string; width: number; dash?: readonly number[] }): SVGSVGElement {
  const namespace = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", "0 0 30 8");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(namespace, "line");
  const attributes = { x1: 0, y1: 4, x2: 30, y2: 4, stroke: stroke.color, "stroke-width": stroke.width + 0.4 };
  for (const [key, value] of Object.entries(attributes)) line.setAttribute(key, String(value));
  if (stroke.dash) line.setAttribute("stroke-dasharray", stroke.dash.join(" "));
  svg.append(line);
  return svg;
}
