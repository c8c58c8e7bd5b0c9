// Draws the deformed section at one frame: colours of cells, outlines, what yields, and the contact under the caisson.
"use strict";
function deformed(data, canvas) {
  const GROUND = 0, WATER = 1, RIGID = 2, OPEN = 2, DASHES = [[], [6, 3], []], AIR = 20, LINE = "#39424e";
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const numbers = (part) => Float32Array.from(new Int16Array(bytes(part.data).buffer), (value) => value * part.step);
  const points = numbers(data.points), cells = new Uint32Array(bytes(data.cells).buffer);
  const displacement = numbers(data.displacement), pressure = bytes(data.pressure);
  const strength = data.strength && bytes(data.strength.data);
  const context = canvas.getContext("2d"), nodes = points.length / 2, count = cells.length / 4;
  const byKind = [GROUND, WATER, RIGID].map((kind) => Array.from(data.kinds.keys()).filter((cell) => data.kinds[cell] === kind));
  const [x0, x1, y0, y1] = data.box;
  let scale = 1, ratio = 1, filled, x = new Float32Array(nodes), y = new Float32Array(nodes);

  // A colour for each byte: of a pressure 256 from suction to pressure, of strength its class; beyond its steps soil has none.
  const {colours: ends} = data.scale;
  const ofPressure = Uint32Array.from({length: 256}, (_, i) => {
    const place = i / 255 * (ends.length - 1), low = Math.min(Math.floor(place), ends.length - 2);
    const mixed = ends[low].map((a, j) => Math.round(a + (place - low) * (ends[low + 1][j] - a)));
    return pixel("#" + mixed.map((part) => part.toString(16).padStart(2, "0")).join(""));
  });
  const ofStrength = Uint32Array.from({length: data.strength ? 256 : 0}, (_, i) => {
    const share = i / data.strength.steps, {limits, colours} = data.strength;
    return pixel(share > 1 ? "#e4e7ec" : colours[limits.filter((limit) => share >= limit).length]);
  });

  // Each edge with the one or two cells beside it.
  const edges = new Map();
  for (let cell = 0; cell < count; ++cell) {
    for (let i = 0; i < 4; ++i) {
      const a = cells[4 * cell + i], b = cells[4 * cell + (i + 1) % 4], key = a < b ? a * nodes + b : b * nodes + a;
      if (edges.has(key)) edges.get(key)[3] = cell; else edges.set(key, [a, b, cell, -1]);
    }
  }
  const all = [...edges.values()];
  // Nodes are apart by kind, so that an edge of one cell alone is of the outline of water, ground or caisson; that of the water
  // stays in place, and where ground moves beside it the ground's own is drawn alone.
  const middle = ([a, b]) => [points[a] + points[b], points[nodes + a] + points[nodes + b]].join();
  const outline = (kind) => all.filter(([, , cell, other]) => other < 0 && data.kinds[cell] === kind);
  const ofGround = outline(GROUND), ofRigid = outline(RIGID), beds = new Set(ofGround.map(middle));
  const ofWater = outline(WATER).filter((edge) => !beds.has(middle(edge)));

  function resize(width) {
    ratio = devicePixelRatio || 1;
    scale = width / (x1 - x0);
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(((y1 - y0) * scale + AIR + 4) * ratio);
    filled = raster(canvas.width, canvas.height);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  function place(frame) {
    const start = 2 * nodes * frame;
    for (let i = 0; i < nodes; ++i) {
      x[i] = (points[i] + data.magnify * displacement[start + 2 * i] - x0) * scale;
      y[i] = (y1 - points[nodes + i] - data.magnify * displacement[start + 2 * i + 1]) * scale + AIR;
    }
  }
  const atRest = (px, py) => [(px - x0) * scale, (y1 - py) * scale + AIR];

  function drawCells(chosen, frame, what) {
    const px = [0, 0, 0, 0], py = [0, 0, 0, 0], value = [0, 0, 0, 0], byCell = what === "strength";
    for (const cell of chosen) {
      for (let i = 0; i < 4; ++i) {
        const node = cells[4 * cell + i];
        px[i] = x[node] * ratio;
        py[i] = y[node] * ratio;
        value[i] = byCell ? strength[frame * count + cell] : pressure[frame * nodes + node];
      }
      filled.cell(px, py, value, byCell ? ofStrength : ofPressure);
    }
  }

  function drawRigid(chosen) {
    context.fillStyle = context.strokeStyle = "#9aa1ad";
    context.beginPath();
    for (const cell of chosen) {
      cells.subarray(4 * cell, 4 * cell + 4).forEach((node, i) => (i ? context.lineTo(x[node], y[node]) : context.moveTo(x[node], y[node])));
      context.closePath();
    }
    context.fill();
    context.stroke();  // closes the seams that antialiasing leaves
  }

  function fill(colour, corners) {
    context.fillStyle = colour;
    context.beginPath();
    for (const corner of corners) context.lineTo(...corner);
    context.fill();
  }

  function stroke(lines, {colour = LINE, width = 1, dash = []} = {}) {
    context.save();
    Object.assign(context, {strokeStyle: colour, lineWidth: width});
    context.setLineDash(dash);
    context.beginPath();
    for (const [first, ...rest] of lines) {
      context.moveTo(...first);
      for (const point of rest) context.lineTo(...point);
    }
    context.stroke();
    context.restore();
  }
  const moved = (chosen, shift = 0) => chosen.map(([a, b]) => [[x[a] + shift, y[a]], [x[b] + shift, y[b]]]);

  // Around soil that mobilises nearly all of its strength.
  function drawZone(frame) {
    const least = data.strength.zone * data.strength.steps, start = frame * count;
    const full = (cell) => cell >= 0 && strength[start + cell] >= least && strength[start + cell] <= data.strength.steps;
    stroke(moved(all.filter(([, , cell, other]) => full(cell) !== full(other))), {colour: "#1c1208", width: 2});
  }

  // Pieces of the bottom in the colour of their node's state; what gapes is filled.
  function drawBottom(frame) {
    const {pairs, place, states, colours} = data.bottom;
    const along = (at, side) => {
      const i = Math.min(Math.floor(at), pairs.length - 2), share = at - i, a = pairs[i][side], b = pairs[i + 1][side];
      return [x[a] + share * (x[b] - x[a]), y[a] + share * (y[b] - y[a])];
    };
    place.forEach((at, node) => {
      const ends = [node ? (place[node - 1] + at) / 2 : at, at, node < place.length - 1 ? (at + place[node + 1]) / 2 : at];
      const above = ends.map((end) => along(end, 0)), below = ends.map((end) => along(end, 1)), state = +states[frame][node];
      if (state === OPEN) {
        context.globalAlpha = 0.35;
        fill(colours[state], [...above, ...below.reverse()]);
        context.globalAlpha = 1;
      }
      stroke([above], {colour: colours[state], width: state ? 4 : 1.5, dash: DASHES[state]});
    });
  }

  function drawCross() {
    const [px, py] = atRest(...data.fails.at), r = 7;
    const lines = [[[px - r, py - r], [px + r, py + r]], [[px - r, py + r], [px + r, py - r]]];
    stroke(lines, {colour: "#ffffff", width: 5});
    stroke(lines, {colour: "#c0392b", width: 2.5});
  }

  function draw(frame, what) {
    place(frame);
    filled.clear();
    drawCells(byKind[WATER], frame, "pressure");
    drawCells(byKind[GROUND], frame, what);
    filled.show(context);
    stroke(moved(data.seams), {width: 0.8, dash: [5, 3]});
    stroke([...moved(ofWater), ...moved(ofGround)]);
    drawRigid(byKind[RIGID]);
    stroke(moved(ofRigid));
    stroke(ofRigid.map((edge) => edge.slice(0, 2).map((node) => atRest(points[node], points[nodes + node]))), {dash: [5, 4]});
    if (strength) drawZone(frame);
    if (data.bottom) drawBottom(frame);
    if (data.slip) stroke(moved(ofRigid, data.magnify * data.slip[frame] * scale), {colour: "#7b4fa3", width: 2, dash: [2, 3]});
    if (data.fails) drawCross();
  }

  return {resize, draw};
}
