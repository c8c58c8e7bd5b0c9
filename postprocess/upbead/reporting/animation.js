// Plays the deformed section, and moves it through time together with the plots: a slider, a button, what is coloured.
"use strict";
(() => {
  const figure = document.querySelector("figure.animation");
  if (!figure) return;
  const WORDS = JSON.parse(document.querySelector("script.words").textContent);
  const SECONDS = 8;  // a whole run is played in so many
  const data = JSON.parse(figure.querySelector("script.fields").textContent), last = data.times.length - 1;

  const made = (name, attributes) => Object.assign(document.createElement(name), attributes);
  const host = made("div", {className: "live-fields live"}), tools = made("div", {className: "tools"});
  const canvas = made("canvas"), play = made("button", {type: "button"}), clockFace = made("output"), told = made("p", {className: "told"});
  const slider = made("input", {type: "range", min: 0, max: last, step: 1, value: data.start});
  canvas.setAttribute("role", "img");
  slider.setAttribute("aria-label", WORDS.time);
  clockFace.setAttribute("aria-live", "off");  // the slider tells the same
  host.append(canvas);
  tools.append(play, slider, clockFace);
  figure.insertBefore(host, figure.firstChild);
  host.after(tools, told);

  const section = deformed(data, canvas);
  let what = "pressure", playing = null;
  if (data.strength) addChoice();

  function addChoice() {
    const label = made("label", {textContent: WORDS.colour + " "}), choice = made("select");
    choice.append(...[["pressure", WORDS["pore pressure"]], ["strength", WORDS["strength mobilised"]]].map(([value, text]) => made("option", {value, text})));
    choice.addEventListener("change", () => {
      what = choice.value;
      for (const name of ["pressure", "strength"]) figure.querySelector(`.of-${name}`).hidden = name !== what;
      show(+slider.value);
    });
    label.append(choice);
    tools.append(label);
  }

  function show(frame) {
    const parts = [data.bottom, data.strength].filter(Boolean).map((part) => part.told[frame]);
    const time = data.times[frame].toPrecision(3) + " s", words = [time, ...parts].join("; ");
    slider.value = frame;
    section.draw(frame, what);
    clockFace.textContent = time;
    told.textContent = parts.join("; ");
    told.hidden = !parts.length;
    if (playing !== null) return;  // nobody reads along
    slider.setAttribute("aria-valuetext", words);
    canvas.setAttribute("aria-label", WORDS["deformed section"] + ": " + words);
  }

  function go(frame) {
    show(Math.min(last, Math.max(0, frame)));
    clock.tell(data.times[+slider.value]);
  }

  function stop() {
    cancelAnimationFrame(playing);
    playing = null;
    play.textContent = WORDS.play;
    show(+slider.value);
  }

  function start() {
    const from = +slider.value === last ? 0 : +slider.value, begun = performance.now();
    play.textContent = WORDS.pause;
    const next = () => {
      playing = requestAnimationFrame(next);
      const frame = (from + Math.floor((performance.now() - begun) / (1000 * SECONDS) * (last + 1))) % (last + 1);
      if (frame !== +slider.value) go(frame);
    };
    playing = requestAnimationFrame(next);
  }

  // The frame next to a time; the times ascend.
  function nearest(time) {
    const after = data.times.findIndex((t) => t >= time);
    if (after <= 0) return after ? last : 0;
    return data.times[after] - time < time - data.times[after - 1] ? after : after - 1;
  }

  clock.move = (time) => { stop(); go(nearest(time)); };
  clock.step = (frames) => { stop(); go(+slider.value + frames); };
  play.addEventListener("click", () => (playing === null ? start() : stop()));
  slider.addEventListener("input", () => { stop(); go(+slider.value); });
  new ResizeObserver(() => { section.resize(Math.max(260, host.clientWidth)); show(+slider.value); }).observe(host);
  section.resize(Math.max(260, host.clientWidth));
  stop();
  clock.tell(data.times[data.start], true);
})();
