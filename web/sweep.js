// Puts the page of a sweep together: the runs with their outcomes, the orders of convergence, the figures.

(() => {
  'use strict';

  const data = JSON.parse(document.getElementById('report-data').textContent);
  const [analysis] = JSON.parse(document.getElementById('analysis-data').textContent).analyses;
  const { at, element } = page;
  const finite = value => value !== null && Number.isFinite(value);
  const marks = { complete: ['good', '● complete'], failed: ['bad', '■ failed'], stopped: ['caution', '▲ stopped'], waiting: ['none', '○ waiting'] };
  const outcome_of = key => data.outcomes.find(outcome => outcome.key === key);
  const unit_tag = ({ shown_unit }) => (shown_unit === '1' ? '' : ` (${shown_unit})`);

  function header() {
    const count = state => data.runs.filter(run => run.state === state).length;
    at('kicker').textContent = 'Sweep';
    at('description').textContent = `${data.case}: ${data.keys.map(({ key, values }) => `${key} = ${values.join(', ')}`).join('; ')}. `
      + `${count('complete')} of ${data.runs.length} runs complete${count('failed') ? `, ${count('failed')} failed` : ''}.`;
  }

  function cell(run, outcome) {
    const { value, half_width, twin } = run.outcomes[outcome.key];
    const made = chapters.value_cell(value, half_width, outcome.factor);
    if (finite(value) && finite(twin)) {
      made.append(element('span', { class: 'explain' }, `c ${figures.significant(outcome.factor * twin, 3)}, ${chapters.difference(value, twin)}`));
    }
    return made;
  }

  function state(run) {
    const [mark, text] = marks[run.state];
    const made = element('td', { class: `mark ${mark}` }, text);
    if (run.state === 'failed') made.append(element('span', { class: 'explain' }, run.message.split('\n')[0]));
    return made;
  }

  function runs() {
    for (const part of page.parts(data.outcomes, 5)) {
      at('runs-tables').append(element('div', { class: 'scroll' }, page.table(element('table', { class: 'findings runs' }),
        [...data.keys.map(({ label }) => label), 'state', ...part.map(outcome => `${outcome.label}${unit_tag(outcome)}`)],
        data.runs.map(run => element('tr', { 'data-run': run.name }, ...data.keys.map(({ key }) => element('th', { scope: 'row' }, run.values[key])), state(run),
          ...part.map(outcome => cell(run, outcome)))))));
    }
    if (!data.outcomes.length) {
      at('runs-tables').append(page.table(element('table', { class: 'findings runs' }), [...data.keys.map(({ label }) => label), 'state'],
        data.runs.map(run => element('tr', {}, ...data.keys.map(({ key }) => element('th', { scope: 'row' }, run.values[key])), state(run)))));
    }
  }

  function convergence() {
    const told = data.refinements.filter(({ finding }) => finding);
    if (!told.length) { at('convergence').remove(); return; }
    for (const key of new Set(told.map(study => study.key))) {
      const rows = told.filter(study => study.key === key), several = rows.some(({ others }) => others);
      at('convergence-tables').append(element('div', { class: 'scroll' }, page.table(element('table', { class: 'findings' }),
        [`As ${key} gets smaller`, ...(several ? ['of'] : []), 'order', 'limit', 'grid convergence index', 'fitted order', 'finding'],
        rows.map(study => {
          const outcome = outcome_of(study.outcome), number = (value, half) => chapters.value_cell(value, half, 1, 3);
          const index = element('td', { class: 'number' }, outcome.kind === 'value' && finite(study.fine_grid_index) ? `${figures.significant(100 * study.fine_grid_index, 2)} %` : '–');
          return element('tr', { 'data-key': study.outcome }, element('th', { scope: 'row' }, `${outcome.label}${unit_tag(outcome)}`),
            ...(several ? [element('td', {}, study.others)] : []), number(study.order, study.order_half_width),
            chapters.value_cell(study.limit, study.limit_half_width, outcome.factor), index,
            number(study.fitted_exponent, study.fitted_exponent_half_width), element('td', { class: 'remark' }, elements.tidy(study.finding)));
        }))));
    }
  }

  // Words along an axis stand at 0, 1, 2 ...
  if (data.categories.length) for (const figure of analysis.figures) figure.x.categories = data.categories;

  header();
  runs();
  convergence();
  chapters.titles.sweep = 'The outcomes';
  chapters.add(at('chapters'), [{ name: data.title, index: 0, analysis }]);
  page.contents();
})();
