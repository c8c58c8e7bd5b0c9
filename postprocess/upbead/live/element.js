// An element of the page: attributes, then children (elements or text).
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const key in attributes) if (attributes[key] !== null) made.setAttribute(key, attributes[key]);
  made.append(...children);
  return made;
}

const GREEK = {alpha: "α", beta: "β", eta: "η", lambda: "λ", mu: "μ", tau: "τ"};

// Text with its symbols set: F_T is F in italics with the subscript T, alpha is α.
export function symbolic(text) {
  const set = text.replace(/(?<![A-Za-z0-9_./])(alpha|beta|eta|lambda|mu|tau)(?![A-Za-z])/g, (word) => GREEK[word]);
  return set.split(/(?<![A-Za-z_])([A-Za-zα-ω]_(?:1\/3|[A-Za-z0-9]+))/).map((part, i) => i % 2 === 0 ? part
    : element("span", {}, element("i", {}, part[0]), element("sub", {}, part.slice(2))));
}
