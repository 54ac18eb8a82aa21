// Puts the page of several runs together: overview, what differs, values side by side, chapters of each set of runs.

(() => {
  'use strict';

  const data = JSON.parse(document.getElementById('report-data').textContent);
  const analyses = JSON.parse(document.getElementById('analysis-data').textContent).analyses;
  const { at, element, marked } = page;
  const runs = data.runs.map((run, index) => ({ name: run.name, index, analysis: analyses[index], run }));
  // Where the page has several sets of runs, each set gives its members their colours.
  const heading = run => (data.sets.length > 1 ? run.name : chapters.run_heading(run));
  const marks = { good: '● healthy', caution: '▲ watch', bad: '■ out of range', none: '○ not judged' };

  function header() {
    at('kicker').textContent = runs.length > 1 && data.sets.length === 1 ? runs.map(({ name }) => name).join(' · ') : '';
    if (data.introduction) at('description').textContent = data.introduction;
    else at('description').remove();
  }

  function missing() {
    if (!data.missing.length) return;
    at('missing').append(element('div', { class: 'warnings' }, element('b', {}, 'Not among the given results:'),
      element('ul', {}, ...data.missing.map(({ what, command }) => element('li', {}, `${what}: `, element('code', {}, command))))));
  }

  function overview() {
    const records_only = runs.every(({ run }) => run.kind === 'record');
    if (records_only) at('runs').querySelector('h2').textContent = runs.length > 1 ? 'The records' : 'The record';
    page.table(at('runs-table'), records_only ? ['Record'] : ['Run', 'State', 'What came out'], runs.map(({ name, index, run }) => {
      const state = element('td', { class: `mark ${run.verdict ? run.verdict.status : 'none'}` },
        run.kind === 'record' ? 'laboratory record' : marks[run.verdict.status]);
      const text = element('td', { class: 'remark' });
      if (run.verdict) text.append(element('b', {}, `${run.verdict.headline} `), run.verdict.sentences[0] || '');
      const title = run.title === name ? '' : run.title;
      return element('tr', {}, element('th', { scope: 'row' }, heading({ name, index }),
        element('span', { class: 'explain' }, title), element('span', { class: 'explain' }, run.source === title ? '' : run.source)), ...(records_only ? [] : [state, text]));
    }));
  }

  // A table with a column for each run; of many runs several tables.
  function tables(id, first, rows_of) {
    for (const part of page.parts(runs)) {
      at(id).append(element('div', { class: 'scroll' }, page.table(element('table', { class: part.length > 4 ? 'findings runs many' : 'findings runs' }),
        [first, ...part.map(heading)], rows_of(part))));
    }
  }

  function differences() {
    if (!data.differences.length) { at('differences').remove(); return; }
    tables('differences-tables', 'Key of the case file', part => data.differences.map(row => element('tr', { 'data-key': row.key },
      element('th', { scope: 'row' }, row.key), ...part.map(({ index }) => element('td', {}, row.values[index])))));
  }

  // What the runs cost, beside the thesis' own; worth a table where there are runs to compare it of.
  function costs() {
    if (!(data.costs || []).length || runs.length < 2) return;
    at('differences').after(element('section', { id: 'costs' }, element('h2', {}, 'What the runs cost'), element('div', { id: 'costs-tables' })));
    tables('costs-tables', 'Cost', part => data.costs.map(row => element('tr', { 'data-key': row.key },
      element('th', { scope: 'row' }, row.label), ...part.map(({ index }) => element('td', {}, row.values[index])))));
  }

  // The values of the runs' own summaries.
  function summary() {
    const keys = [...new Set(runs.flatMap(({ run }) => (run.quantities || []).map(({ key }) => key)))];
    if (!keys.length) { at('summary').remove(); return; }
    tables('summary-tables', 'Quantity', part => keys.map(key => {
      const of = ({ run }) => (run.quantities || []).find(row => row.key === key), first = of(runs.find(of));
      const label = element('th', { scope: 'row' }, first.label);
      if (first.symbol) label.append(' ', element('span', { class: 'symbol' }, marked(first.symbol)));
      if (first.unit !== '1') label.append(element('span', { class: 'symbol' }, ' (', marked(first.unit), ')'));
      return element('tr', { 'data-key': key }, label, ...part.map(of).map(quantity));
    }));
  }

  function quantity(row) {
    if (!row) return element('td', { class: 'number' }, '–');
    const { simulated, measured, column, factor, digits } = row;
    const cell = chapters.value_cell(simulated && simulated.value, simulated && simulated.half_width, factor, digits);
    for (const [letter, other] of [['m', measured], ['c', column]]) {
      if (!other) continue;
      const share = simulated ? `, ${chapters.difference(simulated.value, other.value)}` : '';
      cell.append(element('span', { class: 'explain' }, marked(`${letter} ${figures.significant(factor * other.value, 3)}${share}`)));
    }
    return cell;
  }

  function sets() {
    data.sets.forEach((set, number) => {
      const members = set.members.map((index, i) => (data.sets.length > 1 ? { ...runs[index], name: set.names[i] || runs[index].name, index: i } : runs[index])), where = element('div', { class: 'set' });
      at('chapters').append(where);
      if (set.title && data.sets.length > 1) {
        const heading = element('section', { id: `set-${number}`, class: 'set-heading' }, element('h2', {}, set.title));
        if (set.introduction) heading.append(element('p', { class: 'description' }, set.introduction));
        where.append(heading);
      }
      chapters.warnings(where, members);
      chapters.add(where, members, { layout: set.side_by_side ? 'panels' : 'overlay', prefix: `set-${number}-`, only: set.chapters,
        level: data.sets.length > 1 ? 'h3' : 'h2' });
    });
  }

  header();
  missing();
  overview();
  costs();
  differences();
  summary();
  sets();
  page.sources(data.references);
  page.contents();
})();
