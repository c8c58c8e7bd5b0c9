// A choice of words, with its label.
import {element} from "./element.js";

export function choiceOf(key, name, words, chosen) {
  const options = Object.entries(words).map(([value, text]) => element("option", {value, selected: value === chosen ? "" : null}, text));
  const select = element("select", {id: `whatif-${key}`, "data-key": key}, ...options);
  return {select, row: element("div", {class: "field"}, element("label", {for: `whatif-${key}`}, name), select)};
}
