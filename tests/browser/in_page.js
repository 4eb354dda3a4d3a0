// What is looked at inside of a page; each function returns complaints, a text each.
"use strict";

window.bookChecks = (() => {
  // An element as a reader of the report finds it again.
  const named = (element) => {
    const id = element.id ? "#" + element.id : "";
    const kind = String(element.className?.baseVal ?? element.className ?? "").trim();
    const text = (element.textContent || "").trim().replace(/\s+/g, " ").slice(0, 40);
    return `<${element.tagName.toLowerCase()}${id}${kind ? "." + kind.replace(/\s+/g, ".") : ""}>` + (text ? ` "${text}"` : "");
  };
  const shown = (element) => element.checkVisibility({ checkOpacity: true, checkVisibilityCSS: true });
  const frame = () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  const until = async (holds) => {
    for (let i = 0; i < 500 && !holds(); ++i) await new Promise((resolve) => setTimeout(resolve, 20));
  };

  // Until formulas are set; what is folded away is opened.
  const settled = async () => {
    for (const fold of document.querySelectorAll("details")) fold.open = true;
    await until(() => [...document.images].every((image) => image.complete));
    if (!document.querySelector("script[src$='MathJax.js']")) return;
    await until(() => window.MathJax?.Hub?.Queue && window.MathJax.isReady);
    await new Promise((resolve) => window.MathJax.Hub.Queue(resolve));
    await frame();
  };

  const tex = () => {
    const wrong = [];
    // MathJax sets an error as text in a yellow box.
    for (const error of document.querySelectorAll(".merror, .MathJax_Error, .MathJax_SVG rect[fill='rgb(255, 255, 136)'] + g")) {
      wrong.push(`TeX error: ${error.textContent}, in ${error.closest(".MathJax_SVG")?.nextElementSibling?.textContent ?? ""}`);
    }
    for (const script of document.querySelectorAll("script[type^='math/tex']")) {
      const picture = script.previousElementSibling?.querySelector("svg");
      if (!picture || (shown(picture) && picture.getBoundingClientRect().width === 0)) {
        wrong.push(`formula is not set: ${script.textContent.slice(0, 60)}`);
      }
    }
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (/\\f[$[{]|^\s*\\[([]|Math input error|Math Processing Error/.test(node.data) &&
        !node.parentElement.closest("script, style, code, pre, .fragment, .tex2jax_ignore")) {
        wrong.push(`TeX as text: "${node.data.trim().slice(0, 60)}"`);
      }
    }
    return wrong;
  };

  // Pictures that show nothing.
  const drawn = "path, line, rect, circle, ellipse, polygon, polyline, text, image, use, foreignObject";
  const empty = (picture) => {
    const { width, height } = picture.getBoundingClientRect();
    switch (picture.tagName.toLowerCase()) {
      case "img": return !picture.complete || picture.naturalWidth === 0;
      case "object": return !picture.data || (!picture.contentDocument && picture.clientWidth === 0);
      case "canvas": return picture.width === 0 || picture.height === 0;
      default: return !picture.querySelector(drawn) || width === 0 || height === 0;
    }
  };
  const pictures = () =>
    [...document.querySelectorAll("img, object, canvas, svg")]
      .filter((picture) => shown(picture) && !picture.closest(".MathJax_SVG, #MathJax_SVG_Hidden") && !picture.parentElement.closest("svg"))
      .filter((picture) => !picture.querySelector(":scope > defs:only-child") && empty(picture))
      .map((picture) => `empty picture ${named(picture)} ${picture.getAttribute("src") || picture.getAttribute("data") || ""}`);

  // Whether a box between the element and the page scrolls or cuts, so that the page itself does not.
  const inOwnBox = (element) => {
    for (let box = element.parentElement; box && box !== document.body && box.id !== "doc-content"; box = box.parentElement) {
      if (getComputedStyle(box).overflowX !== "visible") return true;
    }
    return false;
  };
  const sideways = () => {
    const width = document.documentElement.clientWidth;
    const wrong = [];
    for (const box of [document.scrollingElement, document.body, document.getElementById("doc-content")]) {
      if (box && box.scrollWidth > box.clientWidth + 1) {
        wrong.push(`${named(box).split(" ")[0]} scrolls sideways: ${box.scrollWidth} px in ${box.clientWidth}`);
      }
    }
    for (const element of document.body.querySelectorAll("*")) {
      const { left, right, width: own } = element.getBoundingClientRect();
      if ((right > width + 1 || left < -1) && own > 1 && !element.ownerSVGElement && shown(element) &&
        !inOwnBox(element) && ![...element.children].some((child) => child.getBoundingClientRect().right > width + 1)) {
        wrong.push(`${named(element)} from ${Math.round(left)} to ${Math.round(right)} px in a page of ${width}`);
      }
    }
    return wrong;
  };

  // ---- contrast --------------------------------------------------------------------------------

  const colours = new Map();
  const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  // A computed colour as red, green, blue and opacity, 0 to 1.
  const colour = (text) => {
    if (!colours.has(text)) {
      const numbers = text.match(/[\d.]+%?/g)?.map(parseFloat) ?? [];
      if (text === "none" || text === "transparent") colours.set(text, [0, 0, 0, 0]);
      else if (text.startsWith("rgb")) colours.set(text, [numbers[0] / 255, numbers[1] / 255, numbers[2] / 255, numbers[3] ?? 1]);
      else {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = text;
        canvas.fillRect(0, 0, 1, 1);
        const [r, g, b, a] = canvas.getImageData(0, 0, 1, 1).data;
        colours.set(text, [r / 255, g / 255, b / 255, a / 255]);
      }
    }
    return colours.get(text);
  };
  const over = ([r, g, b, a], below) => [r * a + below[0] * (1 - a), g * a + below[1] * (1 - a), b * a + below[2] * (1 - a), 1];
  const luminance = (rgb) => {
    const [r, g, b] = rgb.map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ratio = (a, b) => {
    const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x);
    return (high + 0.05) / (low + 0.05);
  };
  const hex = (rgb) => "#" + rgb.slice(0, 3).map((x) => Math.round(x * 255).toString(16).padStart(2, "0")).join("");

  // What lies behind an element: the backgrounds of all that it stands in, from the outside in.
  const background = (element) => {
    const layers = [];
    for (let box = element; box; box = box.parentElement) {
      const layer = colour(getComputedStyle(box).backgroundColor);
      if (layer[3] > 0) layers.push(layer);
      if (layer[3] === 1) break;
    }
    return layers.reduceRight((below, layer) => over(layer, below), [1, 1, 1, 1]);
  };
  const opacity = (element, end) => {
    let all = 1;
    for (let box = element; box && box !== end; box = box.parentElement) all *= parseFloat(getComputedStyle(box).opacity);
    return all;
  };
  const verdict = (element, ink, ground, style) => {
    const size = parseFloat(style.fontSize);
    const needed = size >= 24 || (size >= 18.66 && parseInt(style.fontWeight) >= 700) ? 3 : 4.5;
    const found = ratio(over(ink, ground), ground);
    return found + 0.005 >= needed ? []
      : [`contrast ${found.toFixed(2)}, not ${needed}: ${hex(over(ink, ground))} on ${hex(ground)}, ${named(element)}`];
  };

  const ofText = (element) => {
    const style = getComputedStyle(element);
    const ink = [...colour(style.color)];
    ink[3] *= opacity(element);
    return verdict(element, ink, background(element), style);
  };

  // The colour with which a shape of a figure is filled; of a gradient its middle.
  const filled = (shape, style) => {
    let ink = [...colour(style.fill.startsWith("url") ? "none" : style.fill)];
    if (style.fill.startsWith("url")) {
      const stops = [...(document.querySelector(style.fill.match(/#[^")]*/)[0])?.querySelectorAll("stop") ?? [])];
      const middle = stops[Math.floor(stops.length / 2)];
      if (middle) {
        const at = getComputedStyle(middle);
        ink = [...colour(at.stopColor)];
        ink[3] *= parseFloat(at.stopOpacity);
      }
    }
    ink[3] *= parseFloat(style.fillOpacity) * opacity(shape, shape.ownerSVGElement);
    return ink;
  };

  // Texts of a figure, over the shapes that are painted before them.
  const ofFigure = (figure) => {
    const paper = background(figure.parentElement);
    const own = colour(getComputedStyle(figure).backgroundColor);
    const ground = over(own, paper);
    const shapes = [];
    const wrong = [];
    for (const part of figure.querySelectorAll("path, rect, circle, ellipse, polygon, text")) {
      if (part.closest("defs, clipPath, marker, mask")) continue;
      const style = getComputedStyle(part);
      if (part.tagName !== "text") {
        const ink = filled(part, style);
        if (ink[3] > 0.02) shapes.push({ part, ink, box: part.getBoundingClientRect(), back: part.getScreenCTM()?.inverse() });
        continue;
      }
      const box = part.getBoundingClientRect();
      if (box.width === 0 || !part.textContent.trim()) continue;
      const ink = filled(part, style);
      let worst = [];
      for (const fraction of [0.1, 0.5, 0.9]) {
        const [x, y] = [box.left + fraction * box.width, box.top + box.height / 2];
        let below = ground;
        for (const { part: shape, ink: layer, box: around, back } of shapes) {
          const inside = x >= around.left && x <= around.right && y >= around.top && y <= around.bottom;
          if (inside && back && shape.isPointInFill(new DOMPoint(x, y).matrixTransform(back))) below = over(layer, below);
        }
        if (style.paintOrder.startsWith("stroke") && style.stroke !== "none") {
          const halo = [...colour(style.stroke)];
          halo[3] *= parseFloat(style.strokeOpacity);
          below = over(halo, below);
        }
        const found = verdict(part, ink, below, style);
        if (found.length) worst = found;
      }
      wrong.push(...worst);
    }
    return wrong;
  };

  const contrast = () => {
    const wrong = [];
    const seen = new Set();
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const element = node.parentElement;
      if (!node.data.trim() || seen.has(element) || element.ownerSVGElement || element.closest("script, style, noscript, .MathJax_Preview")) continue;
      seen.add(element);
      if (element.getBoundingClientRect().width > 1 && shown(element)) wrong.push(...ofText(element));
    }
    for (const formula of document.querySelectorAll(".MathJax_SVG")) {
      if (shown(formula)) wrong.push(...ofText(formula));
    }
    for (const field of document.querySelectorAll("input, select, textarea")) {
      // Of a file's field only the button is seen, which has colours of its own.
      if (shown(field) && !["range", "checkbox", "radio", "file"].includes(field.type)) wrong.push(...ofText(field));
    }
    for (const figure of document.querySelectorAll("svg.cookbook-figure")) {
      if (shown(figure)) wrong.push(...ofFigure(figure));
    }
    return wrong;
  };

  // ---- structure -------------------------------------------------------------------------------

  const level = (heading) => parseInt(heading.getAttribute("aria-level") ?? heading.tagName.slice(1));
  const structure = () => {
    const wrong = [];
    if (!document.documentElement.lang) wrong.push("<html> has no lang");
    if (!document.title.trim()) wrong.push("the page has no title");
    let last = 0;
    for (const heading of document.querySelectorAll("h1, h2, h3, h4, h5, h6, [role=heading]")) {
      if (!shown(heading)) continue;
      const now = level(heading);
      if (!heading.textContent.trim()) wrong.push(`empty heading ${named(heading)}`);
      if (now > last + 1) wrong.push(`heading of level ${now} after level ${last}: ${named(heading)}`);
      last = now;
    }
    if (last === 0 && document.querySelector("div.header .title")) wrong.push("the page has no heading");
    return wrong;
  };
  // Links, buttons and fields of which a screen reader could say nothing; quick, for pages of one kind.
  const nameless = () =>
    [...document.querySelectorAll("a[href], button, input, select, textarea, [role=button], img:not([alt]), svg[role=img]")]
      .filter((part) => shown(part) && !part.closest("[aria-hidden=true]"))
      .filter((part) => !["aria-label", "aria-labelledby", "title"].some((name) => part.getAttribute(name)?.trim()) &&
        !(part.labels?.length > 0) && !part.textContent.trim() && !part.querySelector("img[alt]:not([alt='']), svg[role=img]"))
      .map((part) => `without a name: ${named(part)} ${part.getAttribute("href") ?? ""}`);

  const repeated = () => {
    const times = new Map();
    // A figure's title and description are the same where it stands twice, once alive.
    const places = [...document.querySelectorAll("[id]")].filter((place) => !place.closest("svg.cookbook-figure"));
    for (const { id } of places) times.set(id, (times.get(id) ?? 0) + 1);
    return [...times].filter(([, count]) => count > 1).map(([id]) => `id "${id}" stands twice`);
  };

  // Where links lead, and where they may lead to: href and id of all there are.
  const links = () => ({
    links: [...new Set([...document.querySelectorAll("a[href], area[href]")].map((link) => link.href.baseVal ?? link.href))],
    places: [...document.querySelectorAll("[id], a[name]")].flatMap((place) => [place.id, place.getAttribute("name")]).filter(Boolean),
  });

  return { settled, tex, pictures, sideways, contrast, structure, nameless, repeated, links, named };
})();
