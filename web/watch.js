// Follows a run: asks `riffle watch` how it stands, takes new data when there are some, and draws them.

(() => {
  'use strict';

  const { at, element, tidy, marked } = elements;
  const poll_interval = 2000;  // ms
  const number = figures.significant;

  // Screen readers read an element anew when its text is set: only on a change.
  function say(id, text) { if (at(id).textContent !== text) at(id).textContent = text; }

  const states = {
    waiting: ['none', 'Waiting for the first results'],
    running: ['running', 'Running'],
    finished: ['good', 'Finished'],
    stopped: ['caution', 'Stopped'],
    failed: ['bad', 'Failed'],
    unseen: ['caution', 'Running, or killed: no process seen'],
    lost: ['bad', 'Ended without a word'],
  };

  function duration(seconds) {
    if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return '–';
    if (seconds < 90) return `${Math.round(seconds)} s`;
    if (seconds < 5400) return `${Math.round(seconds / 60)} min`;
    if (seconds < 172800) return `${Math.floor(seconds / 3600)} h ${String(Math.floor(seconds % 3600 / 60)).padStart(2, '0')} min`;
    return `${(seconds / 86400).toFixed(1)} days`;
  }

  const grouped = value => Math.round(value).toString().replace(/\B(?=(\d{3})+$)/g, '\u2009');

  let data = null, status = null, received = 0;

  // Simulated time that a running run has probably reached: at its speed, since its last write.
  const since_write = () => status && status.age !== null ? status.age + (performance.now() - received) / 1000 : 0;

  function show_state() {
    if (!status) return;
    const unreadable = Boolean(data && data.error);
    const [style, headline] = unreadable ? ['bad', 'The results cannot be read'] : states[status.state] || ['none', status.state];
    at('state').className = `verdict ${style}`;
    document.documentElement.dataset.state = unreadable ? 'unreadable' : status.state;
    say('state-headline', headline);
    say('state-reason', tidy(status.reason));
    const log = status.log || [];
    at('log').hidden = !log.length;
    say('log-text', log.join('\n'));
    say('source', `Results: ${status.results}. This page only reads; closing it does not disturb the run.`);
    const p = data && data.progress;
    const name = data && data.title ? `${data.title} – Riffle` : 'Riffle watch';
    document.title = p && status.state === 'running' ? `${Math.floor(100 * share(p))} % · ${name}` : `${headline} · ${name}`;
  }

  // A run that ends on convergence has no known end: its share is that of the latest end.
  const share = p => p.end_time > 0 ? Math.min(1, p.time / p.end_time) : 0;

  // A run that has finished early has come to its end all the same.
  function show_share() {
    const p = data.progress, finished = status && status.state === 'finished';
    at('progress-bar').value = finished ? 1 : share(p);
    say('progress-text', finished ? `${number(p.time, 4)} s simulated`
      : `${number(p.time, 4)} of ${p.until_converged ? 'at most ' : ''}${number(p.end_time, 4)} s simulated`);
  }

  function show_clock() {
    const p = data && data.progress;
    if (!p || !status) return;
    show_share();
    const age = since_write(), running = status.state === 'running';
    const left = value => value === null ? null : Math.max(0, value - age);
    let words = '–';
    if (status.state === 'finished') words = 'none';
    else if (!running) words = 'not running';
    else if (p.seconds_left !== null) {
      words = p.until_converged && p.seconds_left_at_least !== null && p.seconds_left_at_least < p.seconds_left
        ? `${duration(left(p.seconds_left_at_least))} to ${duration(left(p.seconds_left))}, ends when converged`
        : `${p.until_converged ? 'at most ' : ''}${duration(left(p.seconds_left))}`;
    }
    fact('left', 'Time left, at this speed', words);
    fact('written', 'Results written', `${duration(age)} ago`);
    at('progress-note').textContent = running
      ? `Everything here is as of the last write; the run writes about every ${duration(status.write_interval)} ([output] checkpoint_interval).` : '';
  }

  function fact(key, label, value) {
    let holder = at('progress-facts').querySelector(`[data-key="${key}"]`);
    if (!holder) {
      holder = element('div', { 'data-key': key }, element('dt', {}, label), element('dd'));
      at('progress-facts').append(holder);
    }
    const dd = holder.querySelector('dd');
    if (dd.textContent !== value) dd.textContent = value;
  }

  function show_progress() {
    const p = data.progress;
    show_share();
    fact('time', 'Simulated time', `${number(p.time, 4)} s`);
    fact('left', 'Time left, at this speed', '–');
    fact('steps', 'Time steps', grouped(p.steps));
    fact('rate', 'Speed', p.steps_per_second === null ? '–' : `${grouped(p.steps_per_second)} steps/s`);
    fact('updates', 'Particle updates', p.updates_per_second === null ? '–' : `${(p.updates_per_second / 1e6).toFixed(2)} million/s`);
    fact('pace', 'Pace', p.time_per_second === null ? '–' : `${number(p.time_per_second, 3)} s of flow per s`);
    fact('computing', 'Computing time so far', duration(p.wall_seconds));
    fact('particles', 'Particles', grouped(p.particles));
    fact('step', 'Time step', p.time_step > 0 ? `${number(1000 * p.time_step, 3)} ms` : '–');
    fact('threads', 'Threads', p.threads > 0 ? `${p.threads}, ${p.instruction_set}` : '–');
    fact('written', 'Results written', '–');
  }

  function row(cells, attributes = {}) {
    const line = element('tr', attributes);
    cells.forEach((cell, i) => line.append(i === 0 ? element('th', { scope: 'row' }, cell) : cell instanceof Node ? cell : element('td', {}, cell)));
    return line;
  }

  function head(...names) {
    const line = element('tr');
    for (const name of names) line.append(element('th', { scope: 'col' }, name));
    return element('thead', {}, line);
  }

  const percent = value => tidy(`${number(100 * value, 2)} %`);

  function show_convergence() {
    const p = data.progress;
    at('convergence-words').textContent = tidy(`${p.converged ? 'Yes' : 'Not yet'}: ${p.convergence || 'not yet tested'}.`);
    const table = at('convergence-table'), body = element('tbody');
    const mark = passed => element('td', { class: `mark ${passed === null ? 'none' : passed ? 'good' : 'caution'}` },
      passed === null ? '○ not known yet' : passed ? '● met' : '▲ not yet');
    if (p.relaxation_time !== null) {
      const least = p.earliest_end === null ? 4 * p.relaxation_time : p.earliest_end;
      body.append(row(['Length of the record', `${number(p.time, 3)} s`, `at least ${number(least, 3)} s`, mark(p.time >= least)], { 'data-key': 'record' }));
      for (const [key, label, value] of [['interval', tidy('Half-width of the 95 % interval of the mean velocity'), p.half_width],
        ['drift', 'Drift still to come', p.remaining_drift]]) {
        // Before the averages begin, an interval is one of the start-up, not of the steady flow.
        const known = value !== null && p.time >= least;
        body.append(row([label, value === null ? '–' : percent(value), `at most ${percent(p.tolerance)}`, mark(known ? value <= p.tolerance : null)], { 'data-key': key }));
      }
    }
    table.hidden = !body.children.length;
    table.replaceChildren(head('What must be met', 'Now', 'Needed', 'Mark'), body);
  }

  const marks = { good: '● healthy', caution: '▲ watch', bad: '■ out of range', none: '○ for information' };

  function show_health() {
    const { verdict, diagnostics } = data.report;
    const box = at('verdict');
    box.className = `verdict ${verdict.status}`;
    box.replaceChildren(element('p', { class: 'headline' }, verdict.headline), element('p', {}, tidy(verdict.sentences.join(' '))));
    at('health-note').hidden = data.progress.complete || data.progress.converged;
    const body = element('tbody');
    for (const item of diagnostics) {
      const label = element('td', {}, element('b', {}, item.label), element('span', { class: 'explain' }, item.explanation));
      body.append(element('tr', { 'data-key': item.key }, label, element('td', {}, marked(item.value)), element('td', {}, marked(item.healthy)),
        element('td', { class: `mark ${item.status}` }, marks[item.status])));
    }
    if (!diagnostics.length) body.append(element('tr', {}, element('td', { colspan: '4' }, 'The results file holds no diagnostics yet.')));
    at('diagnostics-table').replaceChildren(head('What is watched', 'Value', 'Healthy', 'Mark'), body);
  }

  const config = { responsive: false, displaylogo: false, displayModeBar: 'hover',
    modeBarButtonsToRemove: ['select2d', 'lasso2d', 'autoScale2d'] };

  // The figures of the chapters that follow a run, in this order; the health of its particles stands with its diagnostics.
  const chapters_shown = ['along', 'course', 'statistics', 'profiles', 'particles'];
  const left_out = new Set(['velocity_settling', 'velocity_autocorrelation', 'msep_profile', 'turbulence_intensity_profile', 'eddy_viscosity_profile', 'velocity_gradient_profile']);

  // Draw a figure, or take it away where it cannot be drawn; zoom and hidden curves stay as the reader left them.
  function draw(figure) {
    const id = `figure-${figure.key}`;
    let holder = at(id);
    if (figure.missing || !(figure.curves.length || figure.maps.length)) {
      if (holder) { Plotly.purge(holder.querySelector('.plot')); holder.remove(); }
      return;
    }
    if (!holder) {
      holder = element('figure', { id });
      const wide = figure.maps.length || figure.x.unit === 's' || /along the channel/.test(figure.x.label);
      if (wide) holder.classList.add('wide');
      at(figure.chapter === 'particles' ? 'health-figures' : 'flow-figures').append(holder);
      holder.append(element('div', { class: 'plot', id: `plot-${figure.key}`, role: 'img', 'aria-label': figure.title }), element('figcaption'));
    }
    holder.querySelector('figcaption').replaceChildren(element('b', {}, `${figure.title}. `), marked(units.symbols(figure.caption)));
    const plot = holder.querySelector('.plot'), width = plot.clientWidth, entries = [{ figure, run: '', index: 0 }];
    const built = figure.maps.length ? analysis_panels.maps(entries, width, false) : analysis_figures.single(entries, width);
    Plotly.react(plot, built.traces, { ...built.layout, uirevision: 'kept', width, height: built.height,
      font: { ...built.layout.font, size: width < 400 ? 11.5 : 13 } }, config);
  }

  function draw_all() {
    const { figures: all } = data.analyses.analyses[0];
    for (const chapter of chapters_shown) all.filter(figure => figure.chapter === chapter && !left_out.has(figure.key)).forEach(draw);
    const drawn = at('flow-figures').children.length > 0;
    at('flow-note').textContent = drawn ? '' : 'Nothing has been recorded yet: the figures come with the first write of the run.';
  }

  // The newest snapshot, drawn anew when there is another one.
  let shown_time = null;
  function draw_field() {
    const picture = data.report.field, holder = at('field-figures');
    at('field').hidden = !picture;
    if (!picture) return;
    const { time } = picture.frames[picture.frames.length - 1];
    if (time === shown_time) return;
    shown_time = time;
    const choices = element('div', { class: 'choices', role: 'group', 'aria-label': 'Quantity shown' }), plot = element('div', { class: 'plot', id: 'plot-field' }), readout = element('p', { class: 'readout' });
    holder.replaceChildren(element('figure', { id: 'figure-field' }, choices, plot, readout, element('figcaption', {}, marked(field.caption(data.report)))));
    field.draw(data.report, plot, choices, readout, config, () => plot.clientWidth);
  }

  function show_data() {
    const fault = at('fault');
    fault.hidden = !data.error;
    fault.textContent = data.error || '';
    at('content').hidden = !data.progress;
    if (!data.progress) return;
    say('title', data.title);
    say('kicker', data.report.kicker);
    show_progress();
    at('convergence').hidden = !data.progress.until_converged && data.progress.relaxation_time === null;
    show_convergence();
    show_health();
    draw_all();
    draw_field();
  }

  let revision = null;

  class Unreachable extends Error {}

  async function get(path) {
    let answer = null;
    try { answer = await fetch(path, { cache: 'no-cache' }); } catch { throw new Unreachable(path); }
    if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
    return answer.json();
  }

  async function follow() {
    try {
      status = await get('/status.json');
      received = performance.now();
      if (status.revision !== revision) {
        data = await get('/data.json');
        revision = status.revision;
        show_data();
        document.documentElement.dataset.revision = revision;
      }
      say('connection', '');
      show_state();
      show_clock();
    } catch (error) {
      const gone = error instanceof Unreachable;
      if (!gone) console.error(error);
      say('connection', gone
        ? '`riffle watch` does not answer: it has been ended, or the connection is lost. The page shows what it last knew, and goes on by itself.'
        : `This page has met a fault (${error.message}); reload it.`);
    }
    setTimeout(follow, poll_interval);
  }

  setInterval(show_clock, 1000);
  let waiting = 0;
  addEventListener('resize', () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => { if (data && data.progress) draw_all(); }, 150);
  });
  follow();
})();
