// Saving a figure as a picture and its data as CSV, from the page alone: the files are made in memory.

const save = (() => {
  'use strict';

  function blob(name, content) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(content);
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  const text = (name, content, type = 'text/csv;charset=utf-8') => blob(name, new Blob([content], { type }));

  // The picture keeps the size that it has on the page; PNG has three times the pixels. Drawn for white paper,
  // whatever the colours of the page.
  async function picture(plot, format, name) {
    const url = await Plotly.toImage(plot, { format, width: plot._fullLayout.width, height: plot._fullLayout.height, scale: format === 'png' ? 3 : 1 });
    const body = url.slice(url.indexOf(',') + 1);
    if (format === 'svg') { text(`riffle-${name}.svg`, decodeURIComponent(body), 'image/svg+xml'); return; }
    const bytes = Uint8Array.from(atob(body), letter => letter.charCodeAt(0));
    blob(`riffle-${name}.png`, new Blob([bytes], { type: 'image/png' }));
  }

  // A cell of a CSV file (RFC 4180).
  function cell(value) {
    if (value === null || value === undefined || (typeof value === 'number' && !Number.isFinite(value))) return '';
    const written = String(value);
    return /[",\n\r]/.test(written) ? `"${written.replace(/"/g, '""')}"` : written;
  }

  const rows = list => list.map(row => row.map(cell).join(',')).join('\n') + '\n';
  const comment = text => (text ? text.split('\n').map(line => `# ${line}\n`).join('') : '');
  const heading = (label, unit) => `${label} [${unit || '1'}]`;

  // The files of a figure of the analysis, in the format of `riffle analyse --csv`: one with the curves, one for
  // each map. `entries`: the figure of each run, [{ figure, run }].
  function files_of_figure(key, entries) {
    const first = entries[0].figure, files = [];
    const preamble = comment(first.title) + comment(first.source) + comment(first.caption);
    const curves = entries.flatMap(({ figure, run }) => figure.curves.map(curve => ({ ...curve, run: curve.run || run })));
    if (curves.length) {
      files.push({ name: `${key}.csv`, button: 'CSV', content: () => {
        const names = { half_width: 'half-width of', lower: 'lower bound of', upper: 'upper bound of' };
        const wide = ['x', 'y'].flatMap(side => Object.keys(names).map(part => [side, part]))
          .filter(([side, part]) => curves.some(curve => (curve[`${side}_${part}`] || []).length));
        const head = ['curve', 'run', 'origin', heading(first.x.label, first.x.unit), heading(first.y.label, first.y.unit),
          ...wide.map(([side, part]) => heading(`${names[part]} ${first[side].label}`, first[side].unit))];
        return preamble + rows([head, ...curves.flatMap(curve => curve.x.map((x, i) =>
          [curve.name, curve.run, curve.origin, x, curve.y[i], ...wide.map(([side, part]) => (curve[`${side}_${part}`] || [])[i])]))]);
      } });
    }
    // One file for the maps of each quantity; those of several runs follow each other, with a column that names the run.
    const maps = entries.flatMap(({ figure, run }) => figure.maps.map(map => ({ ...map, run: map.run || run })));
    const quantities = [...new Set(maps.map(map => `${map.label}|${map.unit}`))];
    quantities.forEach((quantity, number) => {
      const members = maps.filter(map => `${map.label}|${map.unit}` === quantity), several = members.length > 1, [{ label, unit, run }] = members;
      files.push({ name: `${key}_map${number ? `_${number + 1}` : ''}.csv`, button: quantities.length > 1 ? `map ${number + 1} CSV` : 'map CSV', content: () => {
        const head = [...(several ? ['run'] : []), heading(first.x.label, first.x.unit), heading(first.y.label, first.y.unit), heading(label, unit)];
        return preamble + comment(!several && run ? `run: ${run}` : '') + rows([head, ...members.flatMap(map => map.y.flatMap((y, j) =>
          map.x.map((x, i) => [...(several ? [map.run] : []), x, y, map.values[j * map.x.length + i]])))]);
      } });
    });
    return files;
  }

  return { text, picture, rows, heading, comment, files_of_figure };
})();
