// What the pages share: tables, and figures that are drawn when they come into view, refitted to
// the window and to paper, and saved as SVG, PNG and CSV.

const page = (() => {
  'use strict';

  const { at, element, marked } = elements;
  let count = 0;

  // A table: names of the columns (text or { text, class }), and rows of cells that are text or nodes.
  function table(holder, columns, rows) {
    const head = element('tr');
    for (const column of columns) {
      const cell = element('th', { scope: 'col' });
      cell.append(column instanceof Node ? column : String(column));
      head.append(cell);
    }
    holder.append(element('thead', {}, head), element('tbody', {}, ...rows));
    return holder;
  }

  // Parts of at most `most` members, as equal as can be: tables of many runs are cut so that they fit the page.
  function parts(list, most = 7) {
    const count = Math.ceil(list.length / most), size = Math.ceil(list.length / count);
    return Array.from({ length: count }, (_, i) => list.slice(i * size, (i + 1) * size));
  }

  const config = {
    responsive: false, displaylogo: false, displayModeBar: 'hover',
    modeBarButtonsToRemove: ['select2d', 'lasso2d', 'autoScale2d', 'toImage'],
  };

  // On paper the column's width is known (A4 with the style's margins, at 96 px per inch) before the browser has
  // laid out the printed page.
  let on_paper = false;
  const paper = { whole: 686, half: 334 };
  const is_half = plot => Boolean(plot.closest('.pair')) && !plot.closest('.wide');
  function width_of(plot) {
    if (!on_paper) return plot.clientWidth;
    return is_half(plot) ? paper.half : paper.whole;
  }

  const figures_of_page = [];
  const observer = 'IntersectionObserver' in window ? new IntersectionObserver(entries => {
    for (const entry of entries) {
      const figure = figures_of_page.find(candidate => candidate.plot === entry.target);
      if (entry.isIntersecting && figure) draw(figure);
    }
  }, { rootMargin: '500px 0px' }) : null;

  function draw(figure) {
    if (figure.is_drawn) return;
    figure.is_drawn = true;
    if (observer) observer.unobserve(figure.plot);
    figure.plot.style.minHeight = '';
    figure.show();
  }

  // A figure joins the page: drawn once it comes near the window, or at once for want of an observer.
  function watch(figure, height) {
    figures_of_page.push(figure);
    figure.plot.style.minHeight = `${height}px`;
    if (observer) observer.observe(figure.plot); else draw(figure);
  }

  function frame(id, where, name) {
    const figure = element('figure', { id: `figure-${id}` });
    (where instanceof Node ? where : at(where)).append(figure);
    figure.dataset.name = name;
    return figure;
  }

  const missing = (figure, text) => figure.append(element('p', { class: 'note' }, text));

  function caption(figure, ...content) {
    count += 1;
    figure.append(element('figcaption', {}, element('b', {}, `Figure ${count}. `), ...content));
  }

  // Buttons below a figure that save it. `files` gives the data: [{ name, button, content() }].
  function tools(figure, plot, name, files, show) {
    const bar = element('div', { class: 'tools', role: 'group', 'aria-label': 'Save the figure' });
    const add = (text, title, save) => {
      const button = element('button', { type: 'button', title }, text);
      button.addEventListener('click', async () => {
        try { if (show) show(); await save(); } catch (error) {
          button.textContent = `${text}: failed`;
          console.error(error);
        }
      });
      bar.append(button);
    };
    for (const format of ['svg', 'png']) {
      add(format.toUpperCase(), `Save the figure as ${format.toUpperCase()}`, () => save.picture(plot, format, name));
    }
    for (const file of files) add(file.button || 'CSV', `Save the data: ${file.name}`, () => save.text(file.name, file.content()));
    figure.append(bar);
  }

  // A figure of Plotly's. `built`: { traces, layout, height, caption, paper_share }, or a function that makes it for a
  // width in pixels, with `height` beside it. Gives the plot's element.
  function plain(figure, id, name, built, files) {
    const plot = element('div', { class: 'plot', id: `plot-${id}`, role: 'img', 'aria-label': name });
    figure.append(plot);
    // Paper and telephones get smaller letters; paper lower figures too, so that three rows share a page.
    const show = () => {
      const width = width_of(plot), small = width < 400, made = typeof built === 'function' ? built(width, on_paper) : built;
      const font = { ...made.layout.font, size: small ? 11.5 : 13 };
      const legends = Object.fromEntries(Object.entries(made.layout).filter(([key]) => key.startsWith('legend'))
        .map(([key, legend]) => [key, { ...legend, maxheight: 2000, font: { size: small ? 10.5 : 12 } }]));
      const legend = made.legend_height || 0;  // as high on paper as on the screen
      const height = Math.round(on_paper ? (made.paper_share || 0.58) * (made.height - legend) + legend : made.height);
      return Plotly.react(plot, made.traces, { ...made.layout, ...legends, font, width, height }, config);
    };
    const entry = { plot, show, is_drawn: false };
    watch(entry, built.height || 420);
    return { plot, draw: () => draw(entry), redraw: () => (entry.is_drawn ? show() : draw(entry)),
      add_tools: () => tools(figure, plot, id, files, () => draw(entry)) };
  }

  // The publications that the page refers to by short names.
  function sources(references) {
    if (!references.length) { at('sources').remove(); return; }
    for (const { name, citation } of references) at('sources-list').append(element('dt', {}, name), element('dd', {}, citation));
  }

  function contents() {
    for (const section of document.querySelectorAll('main section[id]')) {
      const heading = section.querySelector('h2');
      if (heading && !section.hidden) at('contents').append(element('a', { href: `#${section.id}` }, heading.textContent));
    }
  }

  // Refit the figures when the width changes: a resized window, or paper, which needs all of them.
  const refit = () => figures_of_page.filter(figure => figure.is_drawn)
    .forEach(({ plot, show }) => { if (plot._fullLayout && plot._fullLayout.width !== width_of(plot)) show(); });
  let waiting = 0;
  addEventListener('resize', () => { clearTimeout(waiting); waiting = setTimeout(refit, 120); });
  // Paper has nothing to click on: what is folded on the screen is open there.
  let folded = [];
  addEventListener('beforeprint', () => {
    on_paper = true;
    folded = [...document.querySelectorAll('details:not([open])')];
    for (const details of folded) details.open = true;
    refit();
    figures_of_page.forEach(draw);
  });
  addEventListener('afterprint', () => {
    on_paper = false;
    for (const details of folded) details.open = false;
    folded = [];
    refit();
  });

  return { at, element, marked, table, parts, config, frame, missing, caption, tools, plain, watch, width_of, sources, contents };
})();
