// Elements and marked text, shared by the report's pages and the page of `riffle watch`.

const elements = (() => {
  'use strict';

  const at = id => document.getElementById(id);

  function element(tag, attributes = {}, ...content) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...content);
    return made;
  }

  // An interval without bounds tells nothing: the value stays alone, with its unit.
  const certain = text => text.replace(/(%?)\s*(?:±|\+-)\s*(?:inf|nan)(?!\p{L})(\s*%)?/gu, (_, before, after = '') => before || after);

  // Numbers stay on one line with their signs and units.
  const tidy = text => certain(text).replace(/\+- ?/g, '± ').replace(/ %/g, '\u00a0%').replace(/± /g, '±\u00a0');

  // A few tags of our own making (italic symbols with indices) are allowed in labels; anything else is text.
  function marked(text) {
    const holder = document.createElement('span');
    holder.textContent = tidy(text);
    holder.innerHTML = holder.innerHTML.replace(/&lt;(\/?(?:i|b|sub|sup))&gt;/g, '<$1>');
    return holder;
  }

  return { at, element, certain, tidy, marked };
})();
