// The values that are asked, as a link to this page that opens with them.
import {element} from "./element.js";

const MARK = "#ask:";

const asksOf = (root) => [...root.querySelectorAll("select[data-key], input[data-key]")];

// {key: text} of all that is asked within an element.
export function stateOf(root) {
  return Object.fromEntries(asksOf(root).map((control) => [control.dataset.key, control.value]));
}

// Asks for these values. The soil comes first, as it makes the controls, then choices, as they set numbers; the numbers twice, as some move others along.
export function takeState(root, state) {
  const isSoil = ({dataset}) => dataset.key === "soil", isChoice = (control) => control.tagName === "SELECT" && !isSoil(control), isNumber = ({tagName}) => tagName === "INPUT";
  for (const phase of [isSoil, isChoice, isNumber, isNumber])
    for (const control of asksOf(root).filter((one) => phase(one) && one.dataset.key in state)) {
      control.value = state[control.dataset.key];
      control.dispatchEvent(new Event("input"));
    }
}

const begun = {}; // what the page asks by itself

// To be called when a part of the page stands: asks what the link of the page asks of it.
export function openLinked(root) {
  const own = stateOf(root);
  Object.assign(begun, own);
  if (!location.hash.startsWith(MARK)) return;
  const given = Object.fromEntries(new URLSearchParams(location.hash.slice(MARK.length)));
  takeState(root, Object.fromEntries(Object.entries({...own, ...given}).filter(([key]) => key in own)));
}

// The address of the page with all that is asked and is not what it begins with.
export function linkOf() {
  const moved = Object.entries(stateOf(document)).filter(([key, value]) => begun[key] !== value);
  return location.href.split("#")[0] + MARK + new URLSearchParams(moved);
}

// A button that puts the link into the address bar and the clipboard, and says so by say(text).
export function linkButton(say) {
  const button = element("button", {type: "button"}, "Link to these values");
  button.addEventListener("click", async () => {
    const link = linkOf();
    try {
      history.replaceState(null, "", link);
    } catch {
      location.hash = link.slice(link.indexOf("#")); // a frame of a notebook has no address of its own
    }
    try {
      await navigator.clipboard.writeText(link);
      say("The link is in the address bar and on the clipboard; it opens this page with these values.");
    } catch {
      say("The link is in the address bar; it opens this page with these values.");
    }
  });
  return button;
}
