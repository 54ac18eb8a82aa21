// Chapters of the analysis: for each a section with the table of its findings and its figures, of one run or of several.
//   runs: [{ name, index, analysis }]; index fixes the run's colour on the whole page.

const chapters = (() => {
  'use strict';

  const { at, element, marked } = page;
  const titles = {
    run: 'The record', course: 'The course of the flow', along: 'Along the channel', statistics: 'Statistics of the record', profiles: 'Profiles and stresses', section: 'Across the flow: velocity and stress over the cross-section',
    secondary: 'Secondary flow', bed: 'Bed and side walls', fits: 'Velocity laws, roughness and friction',
    surface: 'Free surface', subsurface: 'Fluctuations below the surface', forces: 'Forces on bed, walls and bodies', particles: 'Signs of health of the particles',
  };
  const order = Object.keys(titles);
  const title_of = chapter => titles[chapter] || chapter.charAt(0).toUpperCase() + chapter.slice(1).replace(/_/g, ' ');
  const finite = value => value !== null && value !== undefined && Number.isFinite(value);

  function chapters_of(runs, only) {
    const found = new Set(runs.flatMap(({ analysis }) => [...analysis.figures, ...analysis.findings].map(item => item.chapter)));
    if (only && only.length) return only.filter(chapter => found.has(chapter));
    return [...order.filter(chapter => found.has(chapter)), ...[...found].filter(chapter => !order.includes(chapter))];
  }

  // A number of a finding in its readable unit, with its interval.
  function value_cell(value, half, factor, digits = 4, unit = '') {
    const cell = element('td', { class: 'number' });
    if (!finite(value)) { cell.textContent = '–'; return cell; }
    cell.dataset.value = value;
    const shown = factor * value, width = finite(half) ? factor * half : 0;
    if (width > 0 && Number.isFinite(width)) {
      const [middle, extra] = figures.interval(shown, width);
      cell.append(middle, element('span', { class: 'half' }, ` ± ${extra}`));
    } else cell.append(marked(figures.significant(shown, digits)));
    if (unit) cell.append(' ', element('span', { class: 'symbol' }, marked(unit)));
    return cell;
  }

  function difference(value, reference) {
    const share = finite(value) && finite(reference) && reference !== 0 ? 100 * (value - reference) / Math.abs(reference) : NaN;
    if (!Number.isFinite(share)) return '–';
    if (Math.abs(share) >= 1000) return `${share < 0 ? '−' : '+'}${figures.significant(Math.abs(share) / 100, 2)} ×`;
    return `${share < -0.05 ? '−' : '+'}${Math.abs(share).toFixed(Math.abs(share) < 10 ? 1 : 0)}\u00a0%`;
  }

  const shown_unit = (unit, values) => units.scale(unit, Math.max(0, ...values.filter(finite).map(Math.abs)));

  const unit_tag = unit => (unit === '–' ? '' : element('span', { class: 'symbol' }, ' (', marked(unit), ')'));

  function findings_of_one(findings) {
    const holder = element('table', { class: 'findings' });
    const rows = findings.map(finding => {
      const unit = shown_unit(finding.unit, [finding.value, finding.reference]);
      const label = element('th', { scope: 'row' }, marked(units_text(finding.label)), unit_tag(unit.unit));
      const reference = value_cell(finding.reference, null, unit.factor);
      if (finding.reference_name && finite(finding.reference)) reference.append(element('span', { class: 'explain' }, marked(units_text(finding.reference_name))));
      return element('tr', { 'data-key': finding.key }, label, value_cell(finding.value, finding.half_width, unit.factor), reference,
        element('td', { class: 'number' }, difference(finding.value, finding.reference)), element('td', { class: 'remark' }, marked(units_text(finding.remark || ''))));
    });
    return page.table(holder, ['Finding', 'Value (± 95 %)', 'Reference', 'Difference', 'Remark'], rows);
  }

  // Labels are plain text; their symbols are set as symbols.
  const units_text = text => units.symbols(text).replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&amp;/g, '&');

  // The findings of several runs, a column each; below a value its reference and the difference from it.
  function findings_of_runs(runs, chapter) {
    const keys = [...new Set(runs.flatMap(({ analysis }) => analysis.findings.filter(finding => finding.chapter === chapter).map(finding => finding.key)))];
    if (!keys.length) return null;
    const made = page.parts(runs).map(part => findings_table(runs, part, keys)), remarks = remarks_of(runs, keys);
    if (remarks.length) {
      made.push(element('details', { class: 'remarks' }, element('summary', {}, 'Remarks on these findings'),
        element('ul', {}, ...remarks.map(([label, names, text]) => element('li', {}, element('b', {}, marked(units_text(label)), `${names ? ` (${names})` : ''}: `), marked(units_text(text)))))));
    }
    return made;
  }

  const finding_of = ({ analysis }, key) => analysis.findings.find(finding => finding.key === key);

  // What is said about the findings, once, with the runs that it is said of where it is not all of them.
  function remarks_of(runs, keys) {
    return keys.flatMap(key => {
      const known = runs.filter(run => finding_of(run, key));
      const said = [...new Set(known.map(run => finding_of(run, key).remark).filter(Boolean))];
      return said.map(text => {
        const of = known.filter(run => finding_of(run, key).remark === text).map(({ name }) => name);
        return [finding_of(known[0], key).label, of.length === known.length ? '' : of.join(', '), text];
      });
    });
  }

  // Units are those that fit all runs, so that the parts of a table can be compared.
  function findings_table(runs, part, keys) {
    const rows = keys.map(key => {
      const known = runs.map(run => finding_of(run, key)).filter(Boolean), found = part.map(run => finding_of(run, key)), unit = shown_unit(known[0].unit, known.flatMap(finding => [finding.value, finding.reference]));
      const labels = new Set(known.map(finding => finding.label));
      const cells = found.map(finding => {
        if (!finding) return element('td', { class: 'number' }, '–');
        const cell = value_cell(finding.value, finding.half_width, unit.factor);
        if (labels.size > 1) cell.append(element('span', { class: 'explain' }, marked(units_text(finding.label))));
        if (finite(finding.reference)) {
          cell.append(element('span', { class: 'explain' }, marked(`${figures.significant(unit.factor * finding.reference, 3)}, ${difference(finding.value, finding.reference)}`)));
        }
        return cell;
      });
      const names = [...new Set(known.map(finding => finding.reference_name).filter(Boolean))];
      const label = element('th', { scope: 'row' }, marked(units_text(known[0].label)), unit_tag(unit.unit));
      if (names.length) label.append(element('span', { class: 'explain' }, 'beneath: ', marked(units_text(names.join('; ')))));
      return element('tr', { 'data-key': key }, label, ...cells);
    });
    return element('div', { class: 'scroll' }, page.table(element('table', { class: part.length > 4 ? 'findings runs many' : 'findings runs' }),
      ['Finding', ...part.map(run_heading)], rows));
  }

  function run_heading({ name, index }) {
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = analysis_style.colour_of_run(index);
    return element('span', { class: 'run' }, swatch, name);
  }

  // Identifiers of figures on the page: the key, made unique where a page shows one several times.
  const used = new Set();
  function identifier(key) {
    let id = key, number = 2;
    while (used.has(id) || at(`figure-${id}`)) id = `${key}-${number++}`;
    used.add(id);
    return id;
  }

  function captions(figure_of_page, entries) {
    const { figure } = entries[0], texts = [...new Set(entries.map(entry => entry.figure.caption))];
    const content = [element('b', {}, `${figure.title}. `), marked(units_text(texts.length === 1 ? texts[0] : ''))];
    if (figure.source) content.push(element('span', { class: 'source' }, marked(units_text(` After ${figure.source}.`.replace(/\.\.$/, '.')))));
    page.caption(figure_of_page, ...content);
    if (texts.length > 1) {
      figure_of_page.append(element('details', { class: 'captions' }, element('summary', {}, 'What each run shows'),
        element('ul', {}, ...entries.map(({ run, figure: own }) => element('li', {}, element('b', {}, `${run}: `), marked(units_text(own.caption)))))));
    }
  }

  // Which runs lack a figure that others have, where their analysis says why.
  function lacking(figure_of_page, runs, key) {
    const without = runs.map(({ name, analysis }) => ({ name, figure: analysis.figures.find(figure => figure.key === key) }))
      .filter(({ figure }) => figure && figure.missing);
    if (!without.length) return;
    figure_of_page.append(element('p', { class: 'lacking' }, `Not shown: ${without.map(({ name, figure }) =>
      `${name} (${figure.missing.replace(/\.$/, '')})`).join('; ')}.`));
  }

  // A column twin far beyond all else (that of a closure without stress, say) would flatten the rest: it is left out, and
  // the page says so.
  function without_far_twins(entries) {
    const reach = (curves, side) => Math.max(0, ...curves.flatMap(curve => curve[side]).filter(finite).map(Math.abs));
    const curves = entries.flatMap(({ figure }) => figure.curves), others = curves.filter(curve => curve.origin !== 'column'), left_out = [];
    if (!others.length || others.length === curves.length) return { entries, left_out };
    const limit = { x: 4 * reach(others, 'x'), y: 4 * reach(others, 'y') };
    const kept = entries.map(entry => ({ ...entry, figure: { ...entry.figure, curves: entry.figure.curves.filter(curve => {
      const side = ['x', 'y'].find(axis => curve.origin === 'column' && reach([curve], axis) > limit[axis] && limit[axis] > 0);
      if (side) {
        const axis = entry.figure[side], unit = units.scale(axis.unit, reach([curve], side));
        left_out.push(`${curve.name} of ${entry.run} (it reaches ${figures.significant(unit.factor * reach([curve], side))} ${unit.unit})`);
      }
      return !side;
    }) } }));
    return { entries: kept, left_out };
  }

  function add_figure(holder, runs, key, layout) {
    const whole = runs.map(({ name, index, analysis }) => ({ run: name, index, figure: analysis.figures.find(figure => figure.key === key) })).filter(({ figure }) => figure);
    const { entries: all, left_out } = without_far_twins(whole);
    const entries = all.filter(({ figure }) => !figure.missing && (figure.curves.length || figure.maps.length));
    const id = identifier(key), figure = page.frame(id, holder, all[0].figure.title);
    if (!entries.length) {
      const reasons = [...new Set(all.map(entry => entry.figure.missing || 'there is nothing to draw.'))];
      page.missing(figure, `${all[0].figure.title}: ${reasons.join('; ')}`);
      return;
    }
    const has_maps = entries.some(entry => entry.figure.maps.length), several = entries.length > 1;
    // Records in time and profiles along the channel need the whole width.
    const long = entries.some(({ figure: { x, curves } }) => !x.logarithmic && ((x.unit === 's' && curves.some(curve => curve.x.length > 300 && curve.mark === 'line'))
      || (x.unit === 'm' && /along the channel/.test(x.label) && curves.length > 0)));
    let panels = several && layout === 'panels';
    const wide = () => figure.classList.toggle('wide', has_maps || long || panels);
    wide();
    const build = (width, on_paper) => (has_maps ? analysis_panels.maps(entries.filter(entry => entry.figure.maps.length), width, on_paper)
      : panels ? analysis_panels.curves(entries, width, on_paper) : analysis_figures.single(entries, width, on_paper));
    let choices = null;
    if (several && !has_maps) {
      choices = element('div', { class: 'choices', role: 'group', 'aria-label': 'How the runs are shown' });
      figure.append(choices);
    }
    const rows = Math.ceil(entries.length / 3);
    build.height = has_maps ? 60 + 290 * rows : panels ? 80 + 280 * rows : 430;
    const made = page.plain(figure, id, all[0].figure.title, build, save.files_of_figure(key, whole.filter(({ figure: own }) => !own.missing)));
    if (choices) {
      const buttons = [['overlaid', false], ['side by side', true]].map(([text, value]) => {
        const button = element('button', { type: 'button', 'aria-pressed': String(panels === value) }, text);
        button.addEventListener('click', () => {
          panels = value;
          buttons.forEach((other, i) => other.setAttribute('aria-pressed', String((i === 1) === panels)));
          wide();
          made.redraw();
        });
        return button;
      });
      choices.append(...buttons);
    }
    captions(figure, entries);
    if (several || runs.length > 1) lacking(figure, runs, key);
    if (left_out.length) figure.append(element('p', { class: 'lacking' }, `Beyond the figure, in its CSV file: ${left_out.join('; ')}.`));
    made.add_tools();
  }

  // Sections of all chapters, appended to `where`. options: layout ('overlay', 'panels'), only (these chapters; all
  // without), in this order, prefix of the sections' names, level of their headings.
  function add(where, runs, options = {}) {
    for (const chapter of chapters_of(runs, options.only)) {
      const keys = [...new Set(runs.flatMap(({ analysis }) => analysis.figures.filter(figure => figure.chapter === chapter).map(figure => figure.key)))];
      const section = element('section', { id: `${options.prefix || 'chapter-'}${chapter}`, class: 'chapter' }, element(options.level || 'h2', {}, title_of(chapter)));
      where.append(section);
      if (runs.length === 1) {
        const findings = runs[0].analysis.findings.filter(finding => finding.chapter === chapter);
        if (findings.length) section.append(element('div', { class: 'scroll' }, findings_of_one(findings)));
      } else section.append(...(findings_of_runs(runs, chapter) || []));
      const holder = element('div', { class: 'figures pair' });
      section.append(holder);
      for (const key of keys) add_figure(holder, runs, key, options.layout);
    }
  }

  // The figures of a chapter without heading and findings.
  function figures_of(where, runs, chapter) {
    const keys = runs.flatMap(({ analysis }) => analysis.figures.filter(figure => figure.chapter === chapter).map(figure => figure.key));
    for (const key of new Set(keys)) add_figure(where, runs, key);
  }

  function warnings(where, runs) {
    const list = runs.flatMap(({ name, analysis }) => (analysis.warnings || []).map(text => (runs.length > 1 ? `${name}: ${text}` : text)));
    if (list.length) where.append(element('div', { class: 'warnings' }, element('b', {}, 'The analysis warns:'), element('ul', {}, ...list.map(text => element('li', {}, elements.tidy(text))))));
  }

  return { add, figures_of, add_figure, warnings, run_heading, value_cell, difference, titles };
})();
