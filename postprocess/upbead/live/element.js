// An element of the page: attributes, then children (elements or text).
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const key in attributes) if (attributes[key] !== null) made.setAttribute(key, attributes[key]);
  made.append(...children);
  return made;
}
