// The deformed section and its pore pressure in time, on a canvas, with a slider and a button.
"use strict";
(() => {
  const figure = document.querySelector("figure.animation");
  if (!figure) return;
  const WATER = 1, RIGID = 2, SECONDS = 8;  // a whole run is played in so many seconds
  const WORDS = JSON.parse(document.querySelector("script.words").textContent);
  const data = JSON.parse(figure.querySelector("script.fields").textContent);

  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
  const numbers = (part) => Float32Array.from(new Int16Array(bytes(part.data)), (value) => value * part.step);
  const points = numbers(data.points), cells = new Uint32Array(bytes(data.cells));
  const displacement = numbers(data.displacement), pressure = numbers(data.pressure);
  const nodes = points.length / 2, order = [WATER, 0, RIGID];
  const byKind = order.map((kind) => Array.from(data.kinds.keys()).filter((cell) => data.kinds[cell] === kind));

  // 256 colours from suction to pressure.
  const palette = Array.from({length: 256}, (_, i) => {
    const ends = data.scale.colours, place = i / 255 * (ends.length - 1);
    const low = Math.min(Math.floor(place), ends.length - 2);
    return "rgb(" + ends[low].map((a, j) => Math.round(a + (place - low) * (ends[low + 1][j] - a))).join() + ")";
  });
  const colour = (p) => palette[Math.round(255 * Math.min(1, Math.max(0, (p / data.scale.limit + 1) / 2)))];

  const host = document.createElement("div");
  host.className = "live-fields live";
  const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
  host.append(canvas);
  const tools = document.createElement("div");
  tools.className = "tools";
  const play = document.createElement("button"), slider = document.createElement("input");
  const clock = document.createElement("output");
  play.type = "button";
  Object.assign(slider, {type: "range", min: 0, max: data.times.length - 1, step: 1, value: 0});
  slider.setAttribute("aria-label", WORDS.time);
  tools.append(play, slider, clock);
  figure.insertBefore(host, figure.firstChild);
  figure.insertBefore(tools, host.nextSibling);

  let scale = 1, x = new Float32Array(nodes), y = new Float32Array(nodes), timer = null;
  const [x0, x1, y0, y1] = data.box, air = 20;

  function resize() {
    const width = Math.max(260, host.clientWidth), ratio = devicePixelRatio || 1;
    scale = width / (x1 - x0);
    canvas.width = width * ratio;
    canvas.height = ((y1 - y0) * scale + air + 4) * ratio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    draw();
  }

  // A cell of four corners; large ones in 2 x 2 or 4 x 4 parts, so that colours run smoothly.
  function drawCell(cell, frame) {
    const c = cells.subarray(4 * cell, 4 * cell + 4), p = [0, 1, 2, 3].map((i) => pressure[frame * nodes + c[i]]);
    const size = Math.max(Math.abs(x[c[2]] - x[c[0]]), Math.abs(y[c[2]] - y[c[0]]));
    const parts = size > 24 ? 4 : size > 6 ? 2 : 1;
    const between = (v, s, t) => (1 - s) * (1 - t) * v[0] + s * (1 - t) * v[1] + s * t * v[2] + (1 - s) * t * v[3];
    const cx = [x[c[0]], x[c[1]], x[c[2]], x[c[3]]], cy = [y[c[0]], y[c[1]], y[c[2]], y[c[3]]];
    for (let i = 0; i < parts; ++i) {
      for (let j = 0; j < parts; ++j) {
        const s = [i, i + 1, i + 1, i].map((k) => k / parts), t = [j, j, j + 1, j + 1].map((k) => k / parts);
        context.fillStyle = context.strokeStyle = colour(between(p, (i + 0.5) / parts, (j + 0.5) / parts));
        context.beginPath();
        for (let k = 0; k < 4; ++k) context.lineTo(between(cx, s[k], t[k]), between(cy, s[k], t[k]));
        context.closePath();
        context.fill();
        context.stroke();  // closes the seams that antialiasing leaves
      }
    }
  }

  function drawRigid(cell) {
    const c = cells.subarray(4 * cell, 4 * cell + 4);
    context.fillStyle = context.strokeStyle = "#9aa1ad";
    context.beginPath();
    for (const node of c) context.lineTo(x[node], y[node]);
    context.closePath();
    context.fill();
    context.stroke();
  }

  // Edges that one cell of a kind alone has: the outlines of water, ground and caisson.
  const outlines = byKind.map((chosen) => {
    const count = new Map();
    for (const cell of chosen) {
      for (let i = 0; i < 4; ++i) {
        const a = cells[4 * cell + i], b = cells[4 * cell + (i + 1) % 4], key = a < b ? a + "," + b : b + "," + a;
        count.set(key, (count.get(key) || 0) + 1);
      }
    }
    return [...count].filter(([, n]) => n === 1).map(([key]) => key.split(",").map(Number));
  });

  function drawOutline(edges) {
    context.strokeStyle = "#39424e";
    context.lineWidth = 1;
    context.beginPath();
    for (const [a, b] of edges) {
      context.moveTo(x[a], y[a]);
      context.lineTo(x[b], y[b]);
    }
    context.stroke();
  }

  // Where rigid bodies stand at rest.
  function drawAtRest() {
    const at = (node) => [(points[node] - x0) * scale, (y1 - points[nodes + node]) * scale + air];
    context.save();
    context.strokeStyle = "#39424e";
    context.setLineDash([5, 4]);
    context.beginPath();
    for (const [a, b] of outlines[order.indexOf(RIGID)]) {
      context.moveTo(...at(a));
      context.lineTo(...at(b));
    }
    context.stroke();
    context.restore();
  }

  function draw() {
    const frame = +slider.value, start = 2 * nodes * frame;
    for (let i = 0; i < nodes; ++i) {
      x[i] = (points[i] + data.magnify * displacement[start + 2 * i] - x0) * scale;
      y[i] = (y1 - points[nodes + i] - data.magnify * displacement[start + 2 * i + 1]) * scale + air;
    }
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.lineWidth = 0.7;
    byKind.forEach((chosen, k) => {
      for (const cell of chosen) order[k] === RIGID ? drawRigid(cell) : drawCell(cell, frame);
      drawOutline(outlines[k]);
      context.lineWidth = 0.7;
    });
    drawAtRest();
    clock.textContent = data.times[frame].toPrecision(3) + " s";
  }

  function stop() {
    clearInterval(timer);
    timer = null;
    play.textContent = WORDS.play;
  }

  function start() {
    if (+slider.value === data.times.length - 1) slider.value = 0;
    play.textContent = WORDS.pause;
    timer = setInterval(() => {
      slider.value = (+slider.value + 1) % data.times.length;
      draw();
    }, 1000 * SECONDS / data.times.length);
  }

  play.addEventListener("click", () => (timer === null ? start() : stop()));
  slider.addEventListener("input", () => { stop(); draw(); });
  new ResizeObserver(resize).observe(host);
  slider.value = data.start;
  stop();
  resize();
})();
