// Puts the page together from the data block: verdict, tables, figures, case.

(() => {
  'use strict';

  const data = JSON.parse(document.getElementById('report-data').textContent);
  const { at, element, marked } = page;
  const number = figures.significant;

  function verdict() {
    const box = at('verdict');
    box.className = `verdict ${data.verdict.status}`;
    const headline = element('p', { class: 'headline' });
    headline.textContent = data.verdict.headline;
    const text = element('p');
    text.textContent = data.verdict.sentences.join(' ');
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
    if (half > 0) {
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

  function summary() {
    const table = at('summary-table');
    const head = element('tr');
    for (const text of ['Quantity', 'Simulated (± 95 %)', 'Measured', 'Difference', 'Column twin', 'Difference']) {
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
      line.append(label, value(row.simulated, row.digits, row.factor), value(row.measured, row.digits, row.factor), difference(row.simulated, row.measured),
        value(row.column, row.digits, row.factor), difference(row.simulated, row.column));
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

  const missing = (figure, id, name) =>
    page.missing(figure, `${name}: ${data.notes[id] || 'the results file does not hold the data for this figure.'}`);

  function plain(id, where, name, builder) {
    const figure = page.frame(id, where, name), built = builder(data);
    if (!built) { missing(figure, id, name); return false; }
    const made = page.plain(figure, id, name, built);
    page.caption(figure, marked(built.caption));
    made.add_tools();
    return true;
  }

  function particles() {
    const figure = page.frame('field', 'field-figures', 'Flow field');
    if (!data.snapshot || !field.available(data.snapshot).length) { missing(figure, 'field', 'Flow field'); return; }
    const choices = element('div', { class: 'choices', role: 'group', 'aria-label': 'Quantity shown' });
    const plot = element('div', { class: 'plot', id: 'plot-field', role: 'img', 'aria-label': 'Flow field' });
    const readout = element('p', { class: 'readout' });
    figure.append(choices, plot, readout);
    page.caption(figure, marked(field.caption(data)));
    let show = null;
    page.watch({ plot, is_drawn: false, show: () => {
      if (show) show(); else show = field.draw(data, plot, choices, readout, page.config, () => page.width_of(plot));
    } }, 260);
    page.tools(figure, plot, 'field', [{ name: 'field.csv', button: 'CSV', content: () => field.csv(data.snapshot) }]);
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
  // Each thing once: what the page shows itself does not appear again among the figures of the analysis; what it leaves
  // to those it does not draw.
  const analyses = JSON.parse(at('analysis-data').textContent).analyses;
  const analysed = key => analyses.some(({ figures: all }) => all.some(figure => figure.key === key && !figure.missing));
  const shown = [];
  const own = (id, where, name, builder, key) => { if (plain(id, where, name, builder)) shown.push(key); };
  own('velocity', 'profile-figures', 'Velocity profile', figures.velocity, 'velocity_profile');
  own('log-law', 'profile-figures', 'Logarithmic profile', figures.logLaw, 'log_law');
  own('gradient', 'profile-figures', 'Velocity gradient', figures.gradient, 'velocity_gradient_profile');
  const departs = plain('deviation', 'profile-figures', 'Departure from the column twin', figures.deviation);
  own('stress', 'profile-figures', 'Shear stress', figures.stress, 'stress_profile');
  own('pressure', 'profile-figures', 'Pressure', figures.pressure, 'pressure_profile');
  const forces = !analysed('force_history');
  own('history', 'history-figures', forces ? 'History of velocity, forces and level' : 'History of velocity and level',
    series => figures.history(series, forces), 'velocity_history');
  particles();
  if (!analysed('surface_map')) own('surface', 'field-figures', 'Surface elevation in space and time', figures.surface, 'surface_map');
  // The departure from the column twin once, too: in the analysis then only that from the measured profile.
  const drawn = figure => (departs && figure.key === 'velocity_error_profile' ? { ...figure,
    curves: figure.curves.filter(({ origin }) => origin !== 'column'),
    caption: `${figure.caption} That from the column twin stands among the profiles over the depth.` } : figure);
  const runs = analyses.map((analysis, index) => ({ name: analysis.name, index, analysis: { ...analysis,
    figures: analysis.figures.map(drawn).filter(({ missing: why, curves, maps }) => why || curves.length || maps.length) } }));
  chapters.warnings(at('chapters'), runs);
  chapters.add(at('chapters'), runs, { skip: shown });
  diagnostics();
  plain('health', 'diagnostic-figures', 'Signs of health over time', figures.health);
  facts();
  caseText();
  page.contents();

})();
