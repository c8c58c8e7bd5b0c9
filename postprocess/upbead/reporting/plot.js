// Plots that can be zoomed and read off. Each figure.plot holds its data as JSON and a still picture for paper.
"use strict";
(() => {
  const LEFT = 62, RIGHT = 12, HEAD = 20, TITLE = 17, GAP = 10, FOOT = 38;
  const WORDS = JSON.parse(document.querySelector("script.words").textContent);
  const HINT = matchMedia("(pointer: coarse)").matches
    ? WORDS["Drag across to zoom, pinch, double tap to reset; tap to read off."]
    : WORDS["Drag to zoom, double click to reset; after a click the wheel zooms and arrow keys move. Point to read off."];
  const SCRUBBED = WORDS["Drag or arrow keys: move through time."];
  const namespace = (document.querySelector("svg") || {}).namespaceURI;

  const element = (name, attributes, parent) => {
    const made = document.createElementNS(namespace, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    if (parent) parent.append(made);
    return made;
  };
  const minus = (text) => text.replace("-", "−");

  // The same round numbers as reporting/ticks.py.
  function ticks(low, high, count) {
    if (!(high > low)) return [];
    const stepFor = (wanted) => {
      const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
      return power * [1, 2, 5, 10].find((factor) => factor * power >= raw * (1 - 1e-9));
    };
    let step = stepFor(count);
    while (Math.floor(high / step) - Math.ceil(low / step) < 2) step = stepFor(++count);
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), found = [];
    for (let i = Math.ceil(low / step - 1e-9); i <= Math.floor(high / step + 1e-9); ++i) {
      const digits = {minimumFractionDigits: decimals, maximumFractionDigits: decimals};
      found.push([i * step, minus((i * step + 0).toLocaleString("en", digits))]);
    }
    return found;
  }

  // The same round values of an axis over decades as reporting/ticks.py.
  function decades(low, high, count) {
    let found = [];
    for (const mantissas of [[1, 2, 5], [1, 3], [1]]) {
      found = [];
      for (let power = Math.floor(low); power <= Math.ceil(high); ++power)
        for (const factor of mantissas) found.push(factor * 10 ** power);
      found = found.filter((value) => value >= 10 ** low * (1 - 1e-9) && value <= 10 ** high * (1 + 1e-9));
      if (found.length <= count + 1) break;
    }
    if (found.length < 3) return ticks(10 ** low, 10 ** high, count).filter(([value]) => value > 0).map(([value, text]) => [Math.log10(value), text]);
    return found.map((value) => [Math.log10(value), value.toLocaleString("en", {maximumSignificantDigits: 6, maximumFractionDigits: 12})]);
  }
  const isNamed = (line) => line.symbol.some(([text]) => text.trim());

  // The index of the last point at or before x; the points ascend.
  function before(points, x) {
    let low = 0, high = points.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (points[middle] <= x) low = middle; else high = middle;
    }
    return low;
  }

  // The value of a line at x, straight between its points; null beyond its ends.
  function valueAt(line, x) {
    const last = line.x.length - 1;
    if (last < 0 || x < line.x[0] || x > line.x[last]) return null;
    if (last === 0) return line.y[0];
    const i = before(line.x, x), span = line.x[i + 1] - line.x[i];
    return span > 0 ? line.y[i] + (x - line.x[i]) / span * (line.y[i + 1] - line.y[i]) : line.y[i];
  }

  class Plot {
    constructor(figure) {
      this.data = JSON.parse(figure.querySelector("script.plot").textContent);
      this.view = this.data.window.slice();
      this.pointers = new Map();
      this.ofTime = this.data.symbol[0] === "time";
      this.scrubbed = this.ofTime && figure.classList.contains("scrubbed") && !!document.querySelector("figure.animation");
      this.host = document.createElement("div");
      this.host.className = "live";
      this.host.tabIndex = 0;
      this.host.setAttribute("role", "group");
      this.host.setAttribute("aria-label", figure.id.replaceAll("-", " ") + ": " + WORDS[this.scrubbed ? "plot; arrow keys move through time" : "plot that can be zoomed"]);
      this.svg = element("svg", {}, this.host);
      figure.insertBefore(this.host, figure.firstChild);
      this.addTools(figure);
      this.listen();
      new ResizeObserver(() => this.draw()).observe(this.host);
      new IntersectionObserver((seen) => {
        this.seen = seen.at(-1).isIntersecting;
        if (this.seen) this.tell();
      }).observe(this.host);
      if (this.ofTime) clock.readers.push((time, begins) => this.follow(time, begins));
      this.draw();
    }

    addTools(figure) {
      const tools = document.createElement("div");
      tools.className = "tools";
      const hint = document.createElement("span");
      hint.className = "hint";
      hint.textContent = HINT;
      const button = (text, action) => {
        const made = document.createElement("button");
        made.type = "button";
        made.textContent = text;
        made.addEventListener("click", action);
        tools.append(made);
        return made;
      };
      this.reset = button(WORDS.reset, () => this.show(...this.data.window));
      const [low, high] = this.data.extent;
      if (low < this.data.window[0] || high > this.data.window[1]) button(WORDS["show all"], () => this.show(low, high));
      if (this.scrubbed) hint.textContent = SCRUBBED;
      if (this.scrubbed || !document.querySelector(".hint")) tools.append(hint);
      figure.insertBefore(tools, this.host.nextSibling);
    }

    // ------------------------------------------------------------------------------------------- the view
    show(low, high) {
      const [first, last] = this.data.extent, least = (last - first) / 5000;
      if (high - low < least) return;
      const span = Math.min(high - low, last - first);
      low = Math.min(Math.max(low, first), last - span);
      this.view = [low, low + span];
      this.draw();
    }

    zoom(about, factor) {
      const [low, high] = this.view;
      this.show(about - (about - low) * factor, about + (high - about) * factor);
    }

    xOf(value) {
      return LEFT + (value - this.view[0]) / (this.view[1] - this.view[0]) * (this.width - LEFT - RIGHT);
    }

    valueOf(event) {
      const share = (event.clientX - this.svg.getBoundingClientRect().left - LEFT) / (this.width - LEFT - RIGHT);
      return this.view[0] + Math.min(1, Math.max(0, share)) * (this.view[1] - this.view[0]);
    }

    // Least and largest value within the view, panel by panel; panels of a group share them.
    limits() {
      const [low, high] = this.view, panels = this.data.panels;
      const own = panels.map((panel) => {
        const range = panel.from_zero ? [0, 0] : [Infinity, -Infinity];
        const take = (y) => { range[0] = Math.min(range[0], y); range[1] = Math.max(range[1], y); };
        for (const line of panel.lines) {
          for (let i = 0; i < line.x.length; ++i) if (line.x[i] >= low && line.x[i] <= high) take(line.y[i]);
          for (const edge of [low, high]) { const y = valueAt(line, edge); if (y !== null && !line.dots) take(y); }
        }
        for (const mark of panel.marks) if (mark.x >= low && mark.x <= high) take(mark.y);
        return range[0] > range[1] ? [0, 0] : range;
      });
      return panels.map((panel, i) => {
        const same = own.filter((_, j) => j === i || (panel.group && panels[j].group === panel.group));
        const least = Math.min(...same.map((r) => r[0])), most = Math.max(...same.map((r) => r[1]));
        const room = 0.08 * (most - least || 1);
        return [least - (least < 0 || !panel.from_zero ? room : 0), most + room];
      });
    }

    // ------------------------------------------------------------------------------------------- drawing
    draw() {
      this.width = Math.max(260, this.host.clientWidth);
      const heads = this.data.panels.map((panel) => HEAD + (panel.title ? TITLE : 0));
      const heights = this.data.panels.map((panel, i) => heads[i] + panel.height + GAP);
      const bottom = heights.reduce((a, b) => a + b, 0) - GAP;
      this.svg.setAttribute("viewBox", `0 0 ${this.width} ${bottom + FOOT}`);
      this.svg.style.height = bottom + FOOT + "px";
      this.svg.replaceChildren();
      this.reset.hidden = this.view.every((edge, i) => edge === this.data.window[i]);
      const limits = this.limits();
      let top = 0;
      this.drawn = this.data.panels.map((panel, i) => {
        const drawn = this.drawPanel(panel, limits[i], top + heads[i]);
        top += heights[i];
        return drawn;
      });
      this.drawAxis(bottom);
      this.cursor = element("line", {class: "cursor", y1: HEAD, y2: bottom, visibility: "hidden"}, this.svg);
      this.line = element("line", {class: "now", y1: HEAD, y2: bottom, visibility: "hidden"});
      this.svg.prepend(this.line);  // below the words
      this.shade = element("rect", {class: "shade", y: HEAD, height: bottom - HEAD, visibility: "hidden"}, this.svg);
      this.tell();
    }

    drawPanel(panel, limits, top) {
      const yOf = (value) => top + panel.height * (1 - (value - limits[0]) / (limits[1] - limits[0]));
      const right = this.width - RIGHT;
      for (const [value, text] of ticks(...limits, Math.max(4, Math.floor(panel.height / 26)))) {
        const y = yOf(value);
        element("line", {x1: LEFT, x2: right, y1: y, y2: y, class: value === 0 ? "zero" : "grid"}, this.svg);
        this.write(text, {x: LEFT - 6, y, dy: ".32em", class: "tick", "text-anchor": "end"});
      }
      for (const [value] of this.xTicks()) {
        const x = this.xOf(value);
        element("line", {x1: x, x2: x, y1: top, y2: top + panel.height, class: "grid"}, this.svg);
      }
      const clip = element("svg", {x: LEFT, y: top - HEAD / 4, width: right - LEFT, height: panel.height + HEAD / 2,
        viewBox: `${LEFT} ${top - HEAD / 4} ${right - LEFT} ${panel.height + HEAD / 2}`}, this.svg);
      for (const line of panel.lines) this.drawLine(line, yOf, clip);
      for (const mark of panel.marks) this.drawMark(mark, yOf);
      return {panel, yOf, legend: this.drawLegend(panel, top - 6), dots: panel.lines.map((line) =>
        element("circle", {r: 3.5, class: `dot c${line.colour}`, visibility: "hidden"}, this.svg))};
    }

    drawLine(line, yOf, parent) {
      const first = Math.max(0, before(line.x, this.view[0])), points = [];
      for (let i = first; i < line.x.length; ++i) {
        points.push([this.xOf(line.x[i]).toFixed(1), yOf(line.y[i]).toFixed(1)]);
        if (line.x[i] > this.view[1]) break;
      }
      if (line.dots) {
        for (const [cx, cy] of points) element("circle", {cx, cy, r: 2, class: `dot c${line.colour}`}, parent);
      } else if (points.length) {
        const path = {d: "M" + points.map((p) => p.join(" ")).join("L"), class: `line c${line.colour}`};
        element("path", line.dash ? {...path, "stroke-dasharray": line.dash} : path, parent);
      }
    }

    drawMark(mark, yOf) {
      if (mark.x < this.view[0] || mark.x > this.view[1]) return;
      const x = this.xOf(mark.x), y = yOf(mark.y), left = x > LEFT + 0.7 * (this.width - LEFT - RIGHT);
      element("circle", {cx: x, cy: y, r: 3, class: "mark"}, this.svg);
      this.write(mark.text, {x: x + (left ? -7 : 7), y: y + (mark.y < 0 ? 10 : -1), class: "note",
        "text-anchor": left ? "end" : "start"});
    }

    // Symbol and reading of each line, then the unit. Returns the places of the readings.
    drawLegend(panel, y) {
      if (panel.title) {
        this.fit(this.write(panel.title, {class: "title", "data-y": y - TITLE}));
      }
      const legend = element("text", {class: "legend", "data-y": y}, this.svg);
      const add = (text, attributes = {}, parent = legend) => {
        const span = element("tspan", attributes, parent);
        span.textContent = text;
        return span;
      };
      const readings = panel.lines.map((line) => {
        if (!isNamed(line)) return add("", {class: "reading"});
        const key = add(line.dash ? "╍ " : "━ ", {class: `key c${line.colour}`});
        let lowered = false;
        for (const [text, style] of line.symbol) {
          add(text, {class: style, dy: style === "sub" ? 3 : lowered ? -3 : 0}, key);
          lowered = style === "sub";
        }
        const reading = add("", {class: "reading", dy: lowered ? -3 : 0});
        add("\u2003");
        return reading;
      });
      if (panel.unit) add(`(${panel.unit})`, {class: "tick"});
      this.fit(legend);
      return readings;
    }

    // A legend or title that is too long for the page is drawn smaller.
    fit(legend) {
      const length = legend.getComputedTextLength(), room = this.width - LEFT;
      const scale = length > room ? room / length : 1;
      legend.setAttribute("transform", `translate(${LEFT} ${legend.dataset.y}) scale(${scale})`);
    }

    xTicks() {
      return (this.data.log ? decades : ticks)(...this.view, Math.max(2, Math.min(8, Math.floor(this.width / 80))));
    }

    drawAxis(bottom) {
      for (const [value, text] of this.xTicks()) {
        this.write(text, {x: this.xOf(value), y: bottom + 16, class: "tick", "text-anchor": "middle"});
      }
      const middle = (LEFT + this.width - RIGHT) / 2;
      this.label = this.write(this.data.axis, {x: middle, y: bottom + 33, class: "tick", "text-anchor": "middle"});
    }

    write(text, attributes) {
      const made = element("text", attributes, this.svg);
      made.textContent = text;
      return made;
    }

    // ------------------------------------------------------------------------------------------- reading off
    point(x) {
      this.at = x;
      this.tell();
    }

    // The time of the section's frame, which is read off where nobody points; what is out of sight is told when it is seen.
    follow(time, begins) {
      if (begins && !this.scrubbed) return;
      this.now = time;
      if (this.seen) this.tell();
    }

    tell() {
      const shown = this.now !== undefined && this.now >= this.view[0] && this.now <= this.view[1];
      this.line.setAttribute("visibility", shown ? "visible" : "hidden");
      for (const end of shown ? ["x1", "x2"] : []) this.line.setAttribute(end, this.xOf(this.now));
      const at = this.at ?? this.now;
      if (at !== undefined) this.read(at);
    }

    read(x) {
      const [name, unit] = this.data.symbol, px = this.xOf(x);
      const inside = x >= this.view[0] && x <= this.view[1];
      this.cursor.setAttribute("x1", px);
      this.cursor.setAttribute("x2", px);
      this.cursor.setAttribute("visibility", inside && x !== this.now ? "visible" : "hidden");
      this.label.textContent = `${name} ${minus((this.data.log ? 10 ** x : x).toPrecision(4))} ${unit}`;
      for (const {panel, yOf, legend, dots} of this.drawn) {
        panel.lines.forEach((line, i) => {
          const value = line.dots && !isNamed(line) ? null : valueAt(line, x);  // of scattered points there is none
          legend[i].textContent = value === null ? "" : " " + minus(String(+value.toPrecision(4)));
          dots[i].setAttribute("visibility", value !== null && inside ? "visible" : "hidden");
          if (value === null) return;
          dots[i].setAttribute("cx", px);
          dots[i].setAttribute("cy", yOf(value));
        });
        this.fit(legend[0].parentNode);
      }
    }

    leave() {
      this.at = undefined;
      this.draw();
    }

    // ------------------------------------------------------------------------------------------- hands
    listen() {
      const host = this.host;
      host.addEventListener("pointerdown", (event) => this.down(event));
      host.addEventListener("pointermove", (event) => this.move(event));
      host.addEventListener("pointerup", (event) => this.up(event));
      host.addEventListener("pointercancel", (event) => {
        this.pointers.delete(event.pointerId);
        this.from = this.pinch = undefined;
        this.draw();
      });
      host.addEventListener("pointerleave", (event) => {
        if (event.pointerType === "mouse" && !this.pointers.size) this.leave();
      });
      host.addEventListener("dblclick", () => this.show(...this.data.window));
      host.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
      host.addEventListener("keydown", (event) => this.key(event));
      host.addEventListener("blur", () => this.leave());
    }

    down(event) {
      if (event.pointerType === "mouse" && event.button !== 0) return;
      this.host.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, event.clientX);
      if (this.scrubbed && this.pointers.size === 1) return this.scrub(event);
      if (this.pointers.size === 1) this.from = this.valueOf(event);
      else this.pinch = {span: this.spread(), about: this.valueOf(event)};
      this.point(this.valueOf(event));
    }

    // The frame next to where one drags is shown, and its time read off.
    scrub(event) {
      this.at = undefined;
      clock.move(this.valueOf(event));
    }

    spread() {
      const places = [...this.pointers.values()];
      return Math.max(20, Math.abs(places[0] - places[1]));
    }

    move(event) {
      const x = this.valueOf(event);
      if (this.pointers.has(event.pointerId)) this.pointers.set(event.pointerId, event.clientX);
      if (this.pointers.size === 2 && this.pinch) {
        const span = this.spread();
        this.zoom(this.pinch.about, this.pinch.span / span);
        this.pinch.span = span;
        return;
      }
      if (this.scrubbed && this.pointers.size === 1) return this.scrub(event);
      this.point(x);
      if (this.from === undefined) return;
      const [a, b] = [this.xOf(this.from), this.xOf(x)].sort((p, q) => p - q);
      this.shade.setAttribute("x", a);
      this.shade.setAttribute("width", b - a);
      this.shade.setAttribute("visibility", "visible");
    }

    up(event) {
      this.pointers.delete(event.pointerId);
      const from = this.from, to = this.valueOf(event), pinched = this.pinch !== undefined;
      this.from = undefined;
      if (!this.pointers.size) this.pinch = undefined;
      this.shade.setAttribute("visibility", "hidden");
      if (from === undefined || pinched) return;
      if (Math.abs(this.xOf(from) - this.xOf(to)) > 12) this.show(Math.min(from, to), Math.max(from, to));
      else if (this.ofTime && clock.move) clock.move(to);
    }

    // Without a click before, the wheel moves the page.
    wheel(event) {
      if (document.activeElement !== this.host && !event.ctrlKey) return;
      event.preventDefault();
      this.zoom(this.valueOf(event), Math.exp(Math.sign(event.deltaY) * 0.2));
    }

    key(event) {
      const [low, high] = this.view, span = high - low;
      const along = (way) => (this.scrubbed ? clock.step(way) : this.show(low + way * span / 5, high + way * span / 5));
      const action = {
        ArrowLeft: () => along(-1),
        ArrowRight: () => along(1),
        "+": () => this.zoom((low + high) / 2, 0.7),
        "-": () => this.zoom((low + high) / 2, 1 / 0.7),
        Escape: () => this.show(...this.data.window),
      }[event.key];
      if (!action) return;
      event.preventDefault();
      action();
    }
  }

  document.documentElement.classList.add("scripted");
  for (const figure of document.querySelectorAll("figure.plot")) new Plot(figure);
  addEventListener("beforeprint", () => {
    for (const fold of document.querySelectorAll("section#case details")) fold.open = true;
  });
})();
