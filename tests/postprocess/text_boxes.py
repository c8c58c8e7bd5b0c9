"""Texts of a page in Chromium by their boxes: which lie on another, which leave their figure or the page.

A box of text is as high as its font; letters fill the middle of it. Boxes are therefore taken 15 % lower on either side.
"""

BOXES = """(() => {
  for (const folded of document.querySelectorAll('details')) folded.open = true;
  const SLACK = 1.5, width = document.documentElement.clientWidth, found = [];
  const plain = (text) => text.replace(/\\s+/g, ' ').trim();
  const shown = (item) => { const style = getComputedStyle(item); return style.visibility === 'visible' && +style.opacity > 0; };
  const scrolls = (item) => { for (; item; item = item.parentElement)
    if (/auto|scroll|hidden|clip/.test(getComputedStyle(item).overflowX) && item !== document.documentElement && item !== document.body) return item;
    return null; };
  const block = (item) => { while (item.parentElement && getComputedStyle(item).display.startsWith('inline')) item = item.parentElement; return item; };
  const place = (item) => { const at = item.closest('figure[id], section[id], [id]'); return at ? '#' + at.id + ' ' : ''; };
  const add = (owner, text, box, room) => {
    if (box.width < 1 || box.height < 1) return;
    const cut = 0.15 * box.height;
    found.push({owner, text: plain(text), left: box.left, right: box.right, top: box.top + cut, bottom: box.bottom - cut, room});
  };
  for (const text of document.querySelectorAll('svg text')) {
    if (!text.getClientRects().length || !plain(text.textContent) || !shown(text) || !text.checkVisibility()) continue;
    add(text, text.textContent, text.getBoundingClientRect(), (text.closest('figure') || text.ownerSVGElement).getBoundingClientRect());
  }
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), range = document.createRange();
  while (walker.nextNode()) {
    const node = walker.currentNode, parent = node.parentElement;
    if (!plain(node.data) || parent.closest('svg, script, style, noscript, option, select') || !shown(parent) || !parent.checkVisibility()) continue;
    range.selectNodeContents(node);
    const frame = scrolls(parent), owner = block(parent);
    for (const box of range.getClientRects()) add(owner, node.data, box, frame ? null : {left: 0, right: width});
  }
  const outside = found.filter(({left, right, room}) => room && (left < room.left - SLACK || right > room.right + SLACK))
    .map(({owner, text, left, right}) => `${place(owner)}${text.slice(0, 60)} [${left.toFixed(0)}, ${right.toFixed(0)}]`);
  found.sort((a, b) => a.top - b.top);
  const over = [];
  for (let i = 0; i < found.length; ++i)
    for (let j = i + 1; j < found.length && found[j].top < found[i].bottom - SLACK; ++j) {
      const a = found[i], b = found[j];
      if (a.owner === b.owner || Math.min(a.right, b.right) - Math.max(a.left, b.left) < SLACK) continue;
      if (Math.min(a.bottom, b.bottom) - b.top < SLACK || a.owner.contains(b.owner) && b.owner.closest('svg')) continue;
      over.push(`${place(a.owner)}${a.text.slice(0, 50)} | ${b.text.slice(0, 50)}`);
    }
  return {texts: found.length, over, outside};
})()"""


def boxes(browser):
    """{texts: how many, over: pairs of texts on another, outside: texts beyond their figure or the page} of the open page."""
    return browser.value(BOXES)
