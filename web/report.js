// Puts the page together from the data block and the analysis: verdict, tables, chapters with their figures, picture of
// the flow field, case.

(() => {
  'use strict';

  const data = JSON.parse(document.getElementById('report-data').textContent);
  const analyses = JSON.parse(document.getElementById('analysis-data').textContent).analyses;
  const { at, element, marked } = page;
  const number = figures.significant;

  function verdict() {
    const box = at('verdict');
    box.className = `verdict ${data.verdict.status}`;
    const headline = element('p', { class: 'headline' });
    headline.textContent = data.verdict.headline;
    const text = element('p');
    text.textContent = elements.tidy(data.verdict.sentences.join(' '));
    box.append(headline, text);
    at('kicker').textContent = data.kicker;
    if (data.description) at('description').textContent = data.description;
    else at('description').remove();
  }

  const percent = (value, reference) => value === null || reference === null || !reference ? null : 100 * (value / reference - 1);

  // A value; with an interval, value and half-width to the same decimals, two digits of the half-width.
  function value(cell, digits, factor) {
    const made = element('td', { class: 'number' });
    if (!cell || cell.value === null || cell.value === undefined) { made.textContent = '–'; return made; }
    const shown = factor * cell.value, half = cell.half_width ? factor * cell.half_width : 0;
    made.dataset.value = shown;
    if (half > 0 && Number.isFinite(half)) {
      const [middle, width] = figures.interval(shown, half);
      const extra = element('span', { class: 'half' });
      extra.textContent = ` ± ${width}`;
      made.append(middle, extra);
    } else {
      made.append(marked(number(shown, digits)));
    }
    return made;
  }

  function difference(simulated, other) {
    const made = element('td', { class: 'number' });
    const share = simulated && other ? percent(simulated.value, other.value) : null;
    made.textContent = share === null || !Number.isFinite(share) ? '–'
      : `${share < -0.005 ? '−' : '+'}${Math.abs(share).toFixed(Math.abs(share) < 10 ? 2 : 1)} %`;
    return made;
  }

  // The table has the columns that any of its rows has a value for.
  function summary() {
    if (!data.quantities.length) { at('summary').remove(); return; }
    const beside = [['measured', 'Measured'], ['column', data.twin], ['theory', 'Theory']].filter(([key]) => data.quantities.some(row => row[key]));
    const table = at('summary-table');
    const head = element('tr');
    for (const text of ['Quantity', 'Simulated (± 95 %)', ...beside.flatMap(([, name]) => [name, 'Difference'])]) {
      const cell = element('th', { scope: 'col' });
      cell.textContent = text;
      head.append(cell);
    }
    const body = element('tbody');
    for (const row of data.quantities) {
      const line = element('tr', { 'data-key': row.key });
      const label = element('th', { scope: 'row' }, row.label);
      if (row.symbol) label.append(' ', element('span', { class: 'symbol' }, marked(row.symbol)));
      if (row.unit !== '1') label.append(element('span', { class: 'symbol' }, ' (', marked(row.unit), ')'));
      line.append(label, value(row.simulated, row.digits, row.factor),
        ...beside.flatMap(([key]) => [value(row[key], row.digits, row.factor), difference(row.simulated, row[key])]));
      body.append(line);
    }
    table.append(element('thead', {}, head), body);
    at('summary-note').append(marked(data.summary_note));
  }

  const marks = { good: '● healthy', caution: '▲ watch', bad: '■ out of range', none: '○ for information' };

  function diagnostics() {
    const table = at('diagnostics-table');
    const head = element('tr');
    for (const text of ['What is watched', 'Value', 'Healthy', 'Mark']) {
      const cell = element('th', { scope: 'col' });
      cell.textContent = text;
      head.append(cell);
    }
    const body = element('tbody');
    for (const row of data.diagnostics) {
      const label = element('td', {}, element('b', {}, row.label));
      label.append(element('span', { class: 'explain' }, row.explanation));
      const mark = element('td', { class: `mark ${row.status}` });
      mark.textContent = marks[row.status];
      body.append(element('tr', { 'data-key': row.key }, label, element('td', {}, marked(row.value)), element('td', {}, marked(row.healthy)), mark));
    }
    if (!data.diagnostics.length) body.append(element('tr', {}, element('td', { colspan: '4' }, 'The results file holds no diagnostics yet.')));
    table.append(element('thead', {}, head), body);
  }

  function particles() {
    const figure = page.frame('field', 'field-figures', 'Flow field');
    if (!data.field || !field.available(data.field).length) {
      page.missing(figure, 'Flow field: the results file holds no snapshot ([output] snapshot_interval sets how often one is kept).');
      return;
    }
    const choices = element('div', { class: 'choices', role: 'group', 'aria-label': 'Quantity and time shown' });
    const plot = element('div', { class: 'plot', id: 'plot-field', role: 'img', 'aria-label': 'Flow field' });
    const readout = element('p', { class: 'readout' });
    figure.append(choices, plot, readout);
    page.caption(figure, marked(field.caption(data)));
    let drawn = null;
    page.watch({ plot, is_drawn: false, show: () => {
      if (drawn) drawn.show(); else drawn = field.draw(data, plot, choices, readout, page.config, () => page.width_of(plot));
    } }, 260);
    page.tools(figure, plot, 'field', [{ name: 'field.csv', button: 'CSV', content: () => field.csv(data, drawn ? drawn.frame() : data.field.frames.length - 1) }]);
  }

  function surface_in_plan() {
    const surface = data.moving_surface;
    if (!surface) return;
    const figure = page.frame('moving-surface', 'field-figures', 'Moving surface');
    const choices = element('div', { class: 'choices', role: 'group', 'aria-label': 'View and time shown' });
    const plot = element('div', { class: 'plot', id: 'plot-moving-surface', role: 'img', 'aria-label': 'Moving surface' });
    figure.append(choices, plot);
    page.caption(figure, marked(moving_surface.caption(surface)));
    let drawn = null;
    page.watch({ plot, is_drawn: false, show: () => {
      if (drawn) drawn.show(); else drawn = moving_surface.draw(surface, plot, choices, page.config, () => page.width_of(plot));
    } }, 260);
    page.tools(figure, plot, 'moving-surface', [{ name: 'moving_surface.csv', button: 'CSV', content: () => moving_surface.csv(surface, drawn ? drawn.frame() : surface.frames.length - 1) }]);
  }

  function facts() {
    for (const fact of data.run) at('run-facts').append(element('div', {}, element('dt', {}, fact.label), element('dd', {}, marked(fact.value))));
  }

  function caseText() {
    at('case-text').textContent = data.case_text || 'The results file holds no case.';
    const button = at('copy-case');
    if (!data.case_text) { button.remove(); return; }
    button.addEventListener('click', async () => {
      let copied = false;
      try { await navigator.clipboard.writeText(data.case_text); copied = true; } catch {
        // Pages opened from a file may be denied the clipboard: select the text and use the old way.
        const selection = getSelection();
        selection.selectAllChildren(at('case-text'));
        copied = document.execCommand('copy');
      }
      button.textContent = copied ? 'Copied' : 'Selected: press Ctrl+C';
      setTimeout(() => { button.textContent = 'Copy the case'; }, 2000);
    });
  }

  verdict();
  summary();
  const runs = analyses.map((analysis, index) => ({ name: analysis.name, index, analysis }));
  const { first, then } = data.chapters, health = 'particles';
  const found = [...new Set(analyses.flatMap(analysis => [...analysis.figures, ...analysis.findings].map(({ chapter }) => chapter)))];
  chapters.add(at('first-chapters'), runs, { only: first });
  particles();
  surface_in_plan();
  chapters.warnings(at('chapters'), runs);
  chapters.add(at('chapters'), runs, { only: [...then, ...found.filter(name => ![...first, ...then, health].includes(name))] });
  diagnostics();
  if (found.includes(health)) chapters.figures_of(at('diagnostic-figures'), runs, health);
  facts();
  page.sources(data.references);
  caseText();
  page.contents();
})();
