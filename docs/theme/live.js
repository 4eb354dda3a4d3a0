// Live figures: one driver for all of them. The geometry, the numbers and the drawing are the recipes' own C++,
// compiled to WebAssembly (tools/live); here are events, the places to show things, and the buttons.

// NAME.wasm.js hands over its module as base64, since a page from file:// may fetch nothing.
const liveModules = {};
window.liveModule = (name, base64) => {
  liveModules[name] = WebAssembly.compile(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)));
};

const loadLiveModule = (name) => new Promise((resolve, reject) => {
  if (liveModules[name]) {
    resolve(liveModules[name]);
    return;
  }
  const script = document.createElement("script");
  script.src = document.querySelector("script[src$='live.js']").src.replace(/live\.js$/, `live/${name}.wasm.js`);
  script.addEventListener("load", () => resolve(liveModules[name]));
  script.addEventListener("error", () => reject(new Error(`${script.src} is missing`)));
  document.head.append(script);
});

// A running module: events go in as text, JSON comes out. An error in C++ ends it.
class LiveProgram {
  constructor(module) {
    const imports = { env: { failed: (at) => { throw new Error(this.text(at)); } } };
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      imports[from] ??= {};
      imports[from][name] ??= () => 52; // WASI's ENOSYS: there are no files here
    }
    this.run = new WebAssembly.Instance(module, imports).exports;
    this.run._initialize();
  }

  text(at, length) {
    const bytes = new Uint8Array(this.run.memory.buffer);
    return new TextDecoder().decode(bytes.slice(at, length === undefined ? bytes.indexOf(0, at) : at + length));
  }

  send(events) {
    const bytes = new TextEncoder().encode(events);
    const at = this.run.space(bytes.length);
    new Uint8Array(this.run.memory.buffer).set(bytes, at);
    const json = this.run.send();
    return JSON.parse(this.text(json, this.run.size()));
  }

  picture(width, height) {
    const bytes = new Uint8ClampedArray(this.run.memory.buffer, this.run.pixels(), 4 * width * height);
    return new ImageData(bytes, width, height);
  }
}

const make = (name, attributes = {}, ...children) => {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) {
      element.addEventListener(key.slice(2), value);
    } else {
      element.setAttribute(key, value);
    }
  }
  element.append(...children);
  return element;
};

class LiveFigure {
  constructor(place, module) {
    this.place = place;
    this.module = module;
    this.program = new LiveProgram(module);
    this.controls = {};
    this.handles = {};
    this.playing = false;
    this.visible = true;
    this.queue = "";
    this.clock = 0;
    this.layOut();
    this.send(`${this.theme()}\nwidth ${this.width()}`);
    this.follow();
  }

  // ---- the places ----

  layOut() {
    // The style sheet of the still stays for what is drawn from now on.
    const style = this.place.querySelector("style");
    if (style && !document.head.querySelector("style.cookbook-live")) {
      style.classList.add("cookbook-live");
      document.head.append(style);
    }
    this.canvas = make("canvas", {
      class: "live-picture", tabindex: "0", role: "img", "aria-label": `${this.place.dataset.live}: a scene that moves`,
    });
    this.drawing = make("div", { class: "live-drawing" });
    this.stage = make("div", { class: "live-stage" }, this.canvas, this.drawing);
    this.plots = make("div", { class: "live-plots" });
    this.inputs = make("div", { class: "live-inputs" });
    this.numbers = make("dl", { class: "live-numbers" });
    this.bar = make("div", { class: "live-bar" });
    this.message = make("p", { class: "live-message", role: "alert", hidden: "" });
    this.button("reset", "All as at first", () => this.restart());
    this.playButton = this.button("pause", "Pause", () => this.play(!this.playing));
    this.stepButton = this.button("step", "One step", () => { this.play(false); this.send("step 1"); });
    this.button("link", "Link to this state", () => this.link());
    this.codeButton = this.button("C++", "Copy as C++", () => this.copy(this.shown.code, this.codeButton));
    this.cost = make("span", { class: "live-cost" });
    this.bar.append(this.cost);
    this.place.replaceChildren(this.stage, this.plots, this.inputs, this.numbers, this.bar, this.message);
    this.place.classList.add("is-live");
    this.listenToCanvas();
  }

  button(text, title, onclick) {
    const button = make("button", { type: "button", title, onclick }, text);
    this.bar.append(button);
    return button;
  }

  theme() {
    return `theme ${document.documentElement.classList.contains("dark-mode") ? "dark" : "light"}`;
  }

  width() {
    const { paddingLeft, paddingRight } = getComputedStyle(this.place);
    return Math.floor(this.place.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight));
  }

  // What changes around the figure: theme, width, whether it is seen.
  follow() {
    new MutationObserver(() => this.send(this.theme()))
      .observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
    let width = this.width();
    new ResizeObserver(() => {
      if (Math.abs(this.width() - width) > 4) {
        width = this.width();
        this.later(`width ${width}`);
      }
    }).observe(this.place);
    new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      this.tick();
    }).observe(this.place);
  }

  // ---- events in, outputs out ----

  // Sends at once and shows what comes back.
  send(events) {
    const begin = performance.now();
    try {
      this.show(this.program.send(events));
      this.message.hidden = true;
    } catch (error) {
      this.fail(error, events);
    }
    return performance.now() - begin;
  }

  // Sends with the next frame; a drag that is not yet sent gives way to the next one.
  later(event) {
    const same = (line) => line.split(" ").slice(0, 2).join(" ") === event.split(" ").slice(0, 2).join(" ");
    const lines = this.queue.split("\n").filter((line) => line && !(event.startsWith("drag") && same(line)));
    this.queue = [...lines, event].join("\n");
    this.tick();
  }

  fail(error, events) {
    this.play(false);
    this.say(`${error.message} (at: ${events.split("\n").pop().slice(0, 80)})`);
    const state = this.shown ? this.shown.state : "";
    this.program = new LiveProgram(this.module);
    this.shown = this.program.send(`${this.theme()}\nwidth ${this.width()}\nrestore ${state}`);
  }

  say(message) {
    this.message.textContent = message;
    this.message.hidden = false;
  }

  // A file is tried in a second program first: where it cannot be read, nothing is lost.
  async open(input, file) {
    const event = `file ${input.event} ${encodeURIComponent(file.name)} ${encodeURIComponent(await file.text())}`;
    try {
      new LiveProgram(this.module).send(event);
    } catch (error) {
      this.say(error.message);
      return;
    }
    this.send(event);
    this.play(true);
  }

  show(out) {
    this.shown = out;
    this.showPicture(out);
    this.drawing.hidden = !out.svg;
    if (out.svg) {
      this.showDrawing(out);
    }
    if (out.plots) {
      this.plots.innerHTML = out.plots;
    } else if (this.plots.firstChild) {
      this.plots.replaceChildren();
    }
    if (this.rested && !out.resting) {
      this.play(true);
    }
    out.inputs.forEach((input) => this.showInput(input));
    this.showNumbers(out.numbers);
    this.playButton.hidden = this.stepButton.hidden = !out.moving;
    this.codeButton.hidden = !out.code;
    if (out.moving && this.started === undefined) {
      this.started = true;
      this.play(!window.matchMedia("(prefers-reduced-motion: reduce)").matches);
    }
  }

  showPicture({ picture: [width, height] }) {
    this.canvas.hidden = width === 0;
    if (width === 0) {
      return;
    }
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.canvas.getContext("2d").putImageData(this.program.picture(width, height), 0, 0);
  }

  showDrawing(out) {
    if (!this.sheet) {
      this.sheet = make("div", { class: "live-sheet" });
      this.drawing.append(this.sheet);
    }
    this.sheet.innerHTML = out.svg;
    const svg = this.sheet.firstElementChild;
    this.box = svg.viewBox.baseVal;
    this.drawing.style.width = `${this.box.width}px`;
    out.inputs.filter(({ kind }) => kind === "handle").forEach((input) => this.showHandle(input));
  }

  showNumbers(numbers) {
    while (this.numbers.children.length > numbers.length) {
      this.numbers.lastChild.remove();
    }
    while (this.numbers.children.length < numbers.length) {
      this.numbers.append(make("div", {}, make("dt"), make("dd")));
    }
    numbers.forEach(({ name, value, unit }, i) => {
      const [term, definition] = this.numbers.children[i].children;
      const text = unit ? `${value} ${unit}` : value;
      if (term.textContent !== name) {
        term.textContent = name;
      }
      if (definition.textContent !== text) {
        definition.textContent = text;
      }
    });
  }

  // ---- inputs ----

  showInput(input) {
    if (input.kind === "handle") {
      return;
    }
    const control = this.controls[input.event] ??= this.addControl(input);
    control.row.hidden = !input.asked;
    control.show(input);
  }

  addControl(input) {
    const kinds = { slider: "addSlider", choice: "addChoice", toggle: "addToggle", button: "addButton", file: "addFile" };
    const control = this[kinds[input.kind]](input);
    this.inputs.append(control.row);
    return control;
  }

  addSlider(input) {
    const range = make("input", {
      type: "range", min: input.least, max: input.most, step: "any", "aria-label": input.name,
      oninput: () => this.later(`set ${input.event} ${range.value}`),
      onkeydown: (event) => {
        const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
        if (way) {
          event.preventDefault();
          const step = (input.most - input.least) / (event.shiftKey ? 10 : 100);
          const value = Math.min(input.most, Math.max(input.least, Number(range.value) + way * step));
          this.send(`set ${input.event} ${value}`);
        }
      },
    });
    const value = make("output");
    return {
      row: make("label", { class: "live-slider" }, make("span", {}, input.name), range, value),
      show: (now) => {
        range.min = now.least;
        range.max = now.most;
        range.value = now.x;
        value.textContent = now.unit ? `${now.x} ${now.unit}` : `${now.x}`;
      },
    };
  }

  addChoice(input) {
    const select = make("select", {
      "aria-label": input.name, onchange: () => this.send(`set ${input.event} ${select.selectedIndex}`),
    });
    return {
      row: make("label", { class: "live-choice" }, make("span", {}, input.name), select),
      show: (now) => {
        if (select.length !== now.options.length) {
          select.replaceChildren(...now.options.map((option) => make("option", {}, option)));
        }
        select.selectedIndex = now.x;
      },
    };
  }

  addToggle(input) {
    const box = make("input", {
      type: "checkbox", onchange: () => this.send(`set ${input.event} ${box.checked ? 1 : 0}`),
    });
    return {
      row: make("label", { class: "live-toggle" }, box, make("span", {}, input.name)),
      show: (now) => { box.checked = now.x !== 0; },
    };
  }

  addButton(input) {
    const press = () => { this.send(`press ${input.event}`); this.play(true); };
    return {
      row: make("button", { type: "button", class: "live-do", onclick: press }, input.name),
      show: () => {},
    };
  }

  // A file is opened by its button, or dropped anywhere on the figure.
  addFile(input) {
    const said = make("output");
    const file = make("input", {
      type: "file", "aria-label": input.name,
      onchange: () => { if (file.files.length > 0) { this.open(input, file.files[0]); file.value = ""; } },
    });
    this.place.addEventListener("dragover", (event) => event.preventDefault());
    this.place.addEventListener("drop", (event) => {
      event.preventDefault();
      if (event.dataTransfer.files.length > 0) {
        this.open(input, event.dataTransfer.files[0]);
      }
    });
    return {
      row: make("label", { class: "live-file" }, make("span", {}, input.name), file, said),
      show: (now) => { said.textContent = now.file || "drop one here"; },
    };
  }

  // A handle is a button over the drawing: dragged by mouse or finger, moved by the arrow keys.
  showHandle(input) {
    const handle = this.handles[input.event] ??= this.addHandle(input);
    handle.hidden = !input.asked;
    handle.style.left = `${100 * input.px / this.box.width}%`;
    handle.style.top = `${100 * input.py / this.box.height}%`;
    handle.setAttribute("aria-label", `${input.name} at ${input.x}, ${input.y}; arrow keys move it`);
    handle.at = [input.px, input.py];
  }

  addHandle(input) {
    let grip = null;
    const handle = make("button", {
      type: "button", class: `live-handle live-${input.ink}`, title: `drag ${input.name}`,
      onpointerdown: (event) => {
        event.preventDefault();
        handle.focus();
        handle.setPointerCapture(event.pointerId);
        const [x, y] = this.pixel(event);
        grip = [handle.at[0] - x, handle.at[1] - y];
      },
      onpointermove: (event) => {
        if (grip) {
          const [x, y] = this.pixel(event);
          this.later(`drag ${input.event} ${x + grip[0]} ${y + grip[1]}`);
        }
      },
      onpointerup: () => { grip = null; },
      onpointercancel: () => { grip = null; },
      onkeydown: (event) => {
        const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
        if (way) {
          event.preventDefault();
          const step = event.shiftKey ? 20 : 2;
          this.send(`drag ${input.event} ${handle.at[0] + step * way[0]} ${handle.at[1] + step * way[1]}`);
        }
      },
    });
    this.drawing.append(handle);
    return handle;
  }

  // Where an event is, in pixels of the drawing.
  pixel(event) {
    const place = this.drawing.getBoundingClientRect();
    return [(event.clientX - place.left) / place.width * this.box.width,
      (event.clientY - place.top) / place.height * this.box.height];
  }

  // The picture takes mouse and finger as they are: what they do is for the figure to say.
  listenToCanvas() {
    const tell = (what) => (event) => {
      const place = this.canvas.getBoundingClientRect();
      const x = (event.clientX - place.left) / place.width * this.canvas.width;
      const y = (event.clientY - place.top) / place.height * this.canvas.height;
      this.later(`pointer ${x.toFixed(1)} ${y.toFixed(1)} ${what}${event.deltaY ? ` ${-Math.sign(event.deltaY)}` : ""}`);
    };
    const down = tell("down"), move = tell("move"), up = tell("up");
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.focus({ preventScroll: true });
      this.canvas.setPointerCapture(event.pointerId);
      down(event);
    });
    this.canvas.addEventListener("pointermove", (event) => { if (event.buttons) { move(event); } });
    this.canvas.addEventListener("pointerup", up);
    this.canvas.addEventListener("pointercancel", up);
    // The wheel scrolls the page, unless the picture was taken hold of before.
    this.canvas.addEventListener("wheel", (event) => {
      if (document.activeElement === this.canvas) {
        event.preventDefault();
        move(event);
      }
    }, { passive: false });
  }

  // ---- time ----

  play(on) {
    this.playing = on && this.shown.moving;
    this.rested = false;
    this.playButton.textContent = this.playing ? "pause" : "play";
    this.playButton.title = this.playing ? "Pause" : "Play";
    this.clock = 0;
    this.tick();
  }

  restart() {
    this.send("start");
    this.play(this.shown.moving);
  }

  // Asks for a frame where there is something to do: asleep when unseen or still.
  tick() {
    if (!this.waiting && (this.queue || (this.playing && this.visible))) {
      this.waiting = true;
      requestAnimationFrame((now) => this.frame(now));
    }
  }

  frame(now) {
    this.waiting = false;
    let events = this.queue;
    const touched = events !== "";
    this.queue = "";
    let steps = 0;
    if (this.playing && this.visible) {
      this.clock = this.clock || now - 1000 / 60;
      steps = Math.min(4, Math.floor((now - this.clock) * 60 / 1000 + 0.5)); // late frames are left out
      this.clock = steps === 4 ? now : this.clock + steps * 1000 / 60;
      events += steps > 0 ? `\nstep ${steps}` : "";
    }
    if (events) {
      const cost = this.send(events);
      this.cost.textContent = `${cost.toFixed(1)} ms${steps > 1 ? ` for ${steps} steps` : ""}`;
    }
    if (this.playing && this.shown.resting && !touched) {
      this.play(false);
      this.rested = true; // until something moves again
    }
    this.tick();
  }

  // ---- links ----

  link() {
    const address = `${location.href.replace(/#.*/, "")}#live:${this.place.dataset.live}:${encodeURIComponent(this.shown.state)}`;
    history.replaceState(null, "", address);
    this.copy(address);
  }

  copy(text, button) {
    const said = button ?? [...this.bar.children].find((child) => child.textContent === "link");
    const label = said.textContent;
    const done = () => { said.textContent = "copied"; setTimeout(() => { said.textContent = label; }, 1200); };
    if (navigator.clipboard) {
      navigator.clipboard.writeText(text).then(done, () => {});
    }
  }

  restore(state) {
    this.send(`restore ${state}`);
    this.play(false);
  }
}

const linkedState = () => {
  const [, name, state] = /^#live:([a-z0-9_]+):(.*)$/.exec(location.hash) ?? [];
  return { name, state: state === undefined ? "" : decodeURIComponent(state) };
};

const wakeUp = async (place) => {
  try {
    place.live = new LiveFigure(place, await loadLiveModule(place.dataset.live));
    const { name, state } = linkedState();
    if (name === place.dataset.live) {
      place.live.restore(state);
    }
  } catch (error) {
    console.error(`live figure ${place.dataset.live}: ${error.message}`);
  }
};

window.addEventListener("DOMContentLoaded", () => {
  const built = window.liveFigures ?? [];
  const places = [...document.querySelectorAll(".live")].filter(({ dataset }) => built.includes(dataset.live));
  const nearby = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (isIntersecting) {
        nearby.unobserve(target);
        wakeUp(target);
      }
    }
  }, { rootMargin: "400px" });
  // Text is painted first.
  requestAnimationFrame(() => setTimeout(() => places.forEach((place) => nearby.observe(place))));
  const { name } = linkedState();
  const linked = places.find(({ dataset }) => dataset.live === name);
  linked?.scrollIntoView({ block: "center" });
});

// A link to a state, on the page itself.
window.addEventListener("hashchange", () => {
  const { name, state } = linkedState();
  const place = name && document.querySelector(`.live[data-live="${name}"]`);
  if (place && place.live) {
    place.live.restore(state);
  }
  place?.scrollIntoView({ block: "center" });
});
