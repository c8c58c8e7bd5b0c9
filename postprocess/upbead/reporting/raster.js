// Fills triangles whose values run straight between their corners, pixel by pixel: far faster than a path for each colour.
"use strict";
function raster(width, height) {
  const image = new ImageData(width, height), pixels = new Uint32Array(image.data.buffer);

  // The colours of pixels whose middle lies within; values are numbers of `colours`. Its edges are taken with it: no seams.
  function triangle(ax, ay, av, bx, by, bv, cx, cy, cv, colours) {
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0) return;
    const alongX = ((bv - av) * (cy - ay) - (cv - av) * (by - ay)) / area;
    const alongY = ((cv - av) * (bx - ax) - (bv - av) * (cx - ax)) / area;
    const first = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)), last = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
    for (let row = first; row <= last; ++row) {
      const y = row + 0.5;
      let left = Infinity, right = -Infinity;
      const meet = (px, py, qx, qy) => {
        if (Math.min(py, qy) > y || Math.max(py, qy) < y || py === qy) return;
        const x = px + (y - py) / (qy - py) * (qx - px);
        left = Math.min(left, x);
        right = Math.max(right, x);
      };
      meet(ax, ay, bx, by);
      meet(bx, by, cx, cy);
      meet(cx, cy, ax, ay);
      const from = Math.max(0, Math.ceil(left - 0.501)), to = Math.min(width - 1, Math.floor(right - 0.499));
      let value = av + alongX * (from + 0.5 - ax) + alongY * (y - ay) + 0.5;
      for (let i = row * width + from; i <= row * width + to; ++i, value += alongX) {
        pixels[i] = colours[Math.min(colours.length - 1, Math.max(0, value | 0))];
      }
    }
  }

  // A cell of four corners, by the triangles around its middle.
  function cell(x, y, value, colours) {
    const mean = (four) => (four[0] + four[1] + four[2] + four[3]) / 4, mx = mean(x), my = mean(y), mv = mean(value);
    for (let i = 0; i < 4; ++i) {
      const j = (i + 1) % 4;
      triangle(x[i], y[i], value[i], x[j], y[j], value[j], mx, my, mv, colours);
    }
  }

  return {cell, clear: () => pixels.fill(0), show: (context) => context.putImageData(image, 0, 0)};
}

// "#rrggbb" as a pixel.
function pixel(colour) {
  const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  return (255 << 24 | blue << 16 | green << 8 | red) >>> 0;
}
