// The free surface in plan, moment by moment: maps of its elevation as colours, or as a relief with light on it, drawn
// into a bitmap behind the axes of a figure. A slider leads through the moments, and a button plays them.

const moving_surface = (() => {
  'use strict';

  const views = [
    { key: 'elevation', button: 'elevation' },
    { key: 'light', button: 'relief in light' },
  ];
  // Played at half of the time in which it happens: crests cross a cell of some depths in less than a second.
  const slowed = 2;
  const shadow = [10, 44, 74], bright = [198, 226, 236];
  // No colour of either view: white would be a level at the mean.
  const dry = [154, 154, 154];

  const points_of = surface => surface.x.length * surface.y.length;

  // Elevations of a moment in m, made when it is first shown.
  function frame_of(surface, number) {
    if (!surface.maps) surface.maps = [];
    if (!surface.maps[number]) surface.maps[number] = field.unpacked(surface.frames[number], [-surface.largest, surface.largest]);
    return surface.maps[number];
  }

  // Range that holds all but the extreme 0.5 % over all moments, the same above and below the mean.
  function limit_of(surface) {
    if (surface.limit === undefined) {
      const sample = [], stride = Math.max(1, Math.ceil(points_of(surface) * surface.frames.length / 50000));
      surface.frames.forEach((_, number) => {
        const values = frame_of(surface, number);
        for (let i = number % stride; i < values.length; i += stride) if (Number.isFinite(values[i])) sample.push(Math.abs(values[i]));
      });
      sample.sort((a, b) => a - b);
      surface.limit = sample[Math.ceil(0.99 * (sample.length - 1))] || surface.largest || 1;
    }
    return surface.limit;
  }

  // Number of a point beside the last or the first one: on the other side of a period, else that one itself.
  const next = (i, n, period) => (period ? (i + n) % n : Math.min(Math.max(i, 0), n - 1));

  // The same with its gaps filled from their rims inward, each point by the mean of its neighbours: the curves through
  // four points then have all of them beside a gap too. What is filled is not drawn.
  function filled(surface, values) {
    const nx = surface.x.length, ny = surface.y.length, result = values.slice(), beside = [-1, 0, 1];
    const around = at => beside.flatMap(k => beside.map(m => result[nx * next(Math.floor(at / nx) + k, ny, surface.periodic_across) + next(at % nx + m, nx, surface.periodic_along)]));
    let gaps = [...values.keys()].filter(at => !Number.isFinite(values[at])), rim = gaps;
    while (rim.length) {
      rim = gaps.map(at => [at, around(at).filter(Number.isFinite)]).filter(([, levels]) => levels.length);
      for (const [at, levels] of rim) result[at] = levels.reduce((sum, level) => sum + level, 0) / levels.length;
      gaps = gaps.filter(at => !Number.isFinite(result[at]));
    }
    return result;
  }

  // The same without what is shorter than some points, which rules the slopes: weights 1 2 1 along and across.
  function smoothed(surface, values) {
    const nx = surface.x.length, ny = surface.y.length;
    const mean = (a, b, c) => (Number.isFinite(a) && Number.isFinite(c) ? (a + 2 * b + c) / 4 : b);
    const along = values.map((value, i) => { const start = i - i % nx, at = k => values[start + next(i % nx + k, nx, surface.periodic_along)]; return mean(at(-1), value, at(1)); });
    return along.map((value, i) => { const at = k => along[nx * next(Math.floor(i / nx) + k, ny, surface.periodic_across) + i % nx]; return mean(at(-1), value, at(1)); });
  }

  // Where a place between the points stands: the number of the point before it, and the share of the way to the next.
  // `period`: after which the points repeat, 0 where they do not.
  function place_in(points, at, period) {
    const n = points.length, step = n > 1 ? points[1] - points[0] : 1, share = (at - points[0]) / step;
    if (period) return { first: Math.floor(share), part: share - Math.floor(share), wrap: i => ((i % n) + n) % n };
    const held = Math.min(Math.max(share, 0), n - 1), first = Math.min(Math.floor(held), Math.max(0, n - 2));
    return { first, part: held - first, wrap: i => Math.min(Math.max(i, 0), n - 1) };
  }

  // Weights of the four points around a place: of the cubic through its two neighbours with the slopes of the points
  // (Catmull and Rom), and of the cubic spline that passes by them, whose curvature has no jumps for light to show.
  const through = t => [(-t + 2 * t * t - t ** 3) / 2, (2 - 5 * t * t + 3 * t ** 3) / 2, (t + 4 * t * t - 3 * t ** 3) / 2, (t ** 3 - t * t) / 2];
  const past = t => [(1 - t) ** 3 / 6, (3 * t ** 3 - 6 * t * t + 4) / 6, (-3 * t ** 3 + 3 * t * t + 3 * t + 1) / 6, t ** 3 / 6];

  // Where the pixels of a bitmap stand between the points: the columns, and the rows from the top (the largest y).
  const columns_of = (surface, width) => Array.from({ length: width }, (_, column) => place_in(surface.x, surface.length * (column + 0.5) / width, surface.periodic_along));
  const rows_of = (surface, height) => Array.from({ length: height }, (_, row) => place_in(surface.y, surface.width * (1 - (row + 0.5) / height), surface.periodic_across));

  // Whether there is water at each pixel: whether the point nearest to it has a level.
  function wet(surface, values, width, height) {
    const nearest = ({ first, part, wrap }) => wrap(first + Math.round(part)), columns = columns_of(surface, width).map(nearest);
    return rows_of(surface, height).map(nearest).flatMap(row => columns.map(column => Number.isFinite(values[row * surface.x.length + column])));
  }

  // Elevations on the pixels, row by row, of values without gaps.
  function refined(surface, values, width, height, cubic) {
    const nx = surface.x.length, across = new Float64Array(height * nx), fine = new Float64Array(height * width);
    rows_of(surface, height).forEach(({ first, part, wrap }, row) => {
      const weights = cubic(part), rows = [-1, 0, 1, 2].map(i => nx * wrap(first + i));
      for (let i = 0; i < nx; ++i) across[row * nx + i] = rows.reduce((sum, from, k) => sum + weights[k] * values[from + i], 0);
    });
    columns_of(surface, width).forEach(({ first, part, wrap }, column) => {
      const weights = cubic(part), from = [-1, 0, 1, 2].map(i => wrap(first + i));
      for (let row = 0; row < height; ++row) fine[row * width + column] = from.reduce((sum, i, k) => sum + weights[k] * across[row * nx + i], 0);
    });
    return fine;
  }

  // How many times the slopes are drawn steeper than they are, so that light shows them: two digits, within a bound. Those
  // that stay below what can be seen even so are no waves but rounding, and are left as they are.
  const steepest = 1000, seen = 0.01;
  function steepened(surface) {
    if (surface.steepened === undefined) {
      let squares = 0, count = 0;
      const nx = surface.x.length, dx = nx > 1 ? surface.x[1] - surface.x[0] : 1;
      for (let number = 0; number < surface.frames.length; number += Math.max(1, Math.floor(surface.frames.length / 20))) {
        const values = smoothed(surface, frame_of(surface, number));
        for (let i = 1; i < values.length; ++i) {
          const slope = (values[i] - values[i - 1]) / dx;
          if (i % nx && Number.isFinite(slope)) { squares += slope * slope; count += 1; }
        }
      }
      const rms = Math.sqrt(squares / Math.max(1, count));
      surface.steepened = steepest * rms < seen ? 1 : Number(Math.min(steepest, Math.max(1, 0.45 / rms)).toPrecision(2));
    }
    return surface.steepened;
  }

  const colours_of_light = Array.from({ length: 256 }, (_, i) => shadow.map((value, k) => value + i / 255 * (bright[k] - value)));
  const colours_of_elevation = field.about_zero.steps(256);

  function paint(surface, number, view, width, height) {
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const pen = canvas.getContext('2d'), image = pen.createImageData(width, height), map = frame_of(surface, number), whole = filled(surface, map);
    const fine = view === 'light' ? refined(surface, smoothed(surface, whole), width, height, past) : refined(surface, whole, width, height, through);
    const water = wet(surface, map, width, height);
    const limit = limit_of(surface), scale = steepened(surface), sx = scale * width / (2 * surface.length), sy = scale * height / (2 * surface.width);
    // The sun stands to the upper left, the eye above; what shines lies halfway between the two.
    const [ex, ey, ez] = [-0.55, 0.5, 0.67], size = Math.hypot(ex, ey, ez + 1), [hx, hy, hz] = [ex / size, ey / size, (ez + 1) / size];
    const put = (at, red, green, blue) => { image.data[at] = red; image.data[at + 1] = green; image.data[at + 2] = blue; image.data[at + 3] = 255; };
    for (let row = 0; row < height; ++row) {
      const above = Math.max(row - 1, 0) * width, below = Math.min(row + 1, height - 1) * width;
      for (let column = 0; column < width; ++column) {
        const i = row * width + column;
        if (!water[i]) {
          put(4 * i, ...dry);
        } else if (view === 'elevation') {
          put(4 * i, ...colours_of_elevation[Math.round(255 * Math.min(1, Math.max(0, 0.5 + 0.5 * fine[i] / limit)))]);
        } else {
          const along = -sx * (fine[row * width + Math.min(column + 1, width - 1)] - fine[row * width + Math.max(column - 1, 0)]);
          const across = -sy * (fine[above + column] - fine[below + column]), length = Math.hypot(along, across, 1);
          const [red, green, blue] = colours_of_light[Math.round(255 * Math.min(1, Math.max(0, (along * ex + across * ey + ez) / length)))];
          const shine = 0.55 * Math.max(0, (along * hx + across * hy + hz) / length) ** 60;
          put(4 * i, red + shine * (255 - red), green + shine * (255 - green), blue + shine * (255 - blue));
        }
      }
    }
    pen.putImageData(image, 0, 0);
    return canvas;
  }

  // Draw into `plot`; buttons and slider go into `choices`.
  function draw(surface, plot, choices, config, width_now) {
    const { unit, factor } = units.scale('m', Math.max(surface.length, surface.width));
    let view = views[0], number = surface.frames.length - 1, timer = 0;

    function build() {
      const width = Math.max(280, width_now()), narrow = width < 620, inner = width - (narrow ? 70 : 165);
      const tall = Math.max(110, Math.min(narrow ? 360 : 460, inner * surface.width / surface.length));
      const pixels = Math.min(520, Math.round(inner)), rows = Math.max(40, Math.round(pixels * surface.width / surface.length));
      const limit = limit_of(surface), shown = units.scale('m', limit), colours = [-shown.factor * limit, shown.factor * limit];
      const traces = [{ type: 'scatter', mode: 'markers', x: [null], y: [null], showlegend: false, hoverinfo: 'skip',
        marker: view.key === 'elevation' ? { color: [0], cmin: colours[0], cmax: colours[1], colorscale: field.about_zero.scale, showscale: true,
          colorbar: narrow
            ? { title: { text: `<i>η</i>′ (${shown.unit})`, side: 'top' }, orientation: 'h', thickness: 12, outlinewidth: 0, y: -0.42, yanchor: 'top', nticks: 5 }
            : { title: { text: `<i>η</i>′ (${shown.unit})`, side: 'right' }, thickness: 14, outlinewidth: 0, len: 1.05, nticks: 5 } } : {} }];
      if (surface.velocity && surface.periodic_along) {
        const gone = surface.velocity * (surface.time[number] - surface.time[0]) % surface.length;
        traces.push({ type: 'scatter', mode: 'markers', x: [factor * (gone + surface.length) % (factor * surface.length)], y: [factor * surface.width / 2], showlegend: false, hoverinfo: 'skip',
          marker: { symbol: 'circle-open', size: 13, color: figures.colour.surface, line: { width: 2.5, color: figures.colour.surface } } });
      }
      const layout = figures.layout({
        xaxis: figures.axis(`<i>x</i> along the channel (${unit})`, { range: [0, factor * surface.length], showgrid: false, constrain: 'domain' }),
        yaxis: figures.axis(`<i>y</i> (${unit})`, { range: [0, factor * surface.width], showgrid: false, nticks: 5, scaleanchor: 'x', constrain: 'domain' }),
        margin: { l: 56, r: narrow || view.key === 'elevation' ? 10 : 100, t: 10, b: 48 }, hovermode: false,
        images: [{ source: paint(surface, number, view.key, pixels, rows).toDataURL('image/png'), xref: 'x', yref: 'y', x: 0, y: factor * surface.width,
          sizex: factor * surface.length, sizey: factor * surface.width, sizing: 'stretch', layer: 'below' }],
        width, height: Math.round(tall + (narrow ? 170 : 92)),
      });
      return { traces, layout };
    }

    const show = () => { const { traces, layout } = build(); return Plotly.react(plot, traces, layout, config); };
    const label = document.createElement('label'), input = document.createElement('input'), words = document.createElement('span'), play = document.createElement('button');
    const tell = () => { words.textContent = `t = ${surface.time[number].toFixed(2)} s`; input.setAttribute('aria-valuetext', words.textContent); };
    const go = to => { number = to; input.value = to; tell(); };
    const buttons = views.map(item => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = item.button;
      button.addEventListener('click', () => { view = item; press(); show(); });
      choices.append(button);
      return button;
    });
    const press = () => buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(views[i] === view)));
    const stop = () => { clearTimeout(timer); timer = 0; play.textContent = '▶ play'; play.setAttribute('aria-pressed', 'false'); };
    // The next moment is due after the time between the two, whatever drawing takes.
    const next = async () => {
      if (!timer) return;
      const begun = performance.now(), to = (number + 1) % surface.frames.length;
      const due = to ? 1000 * slowed * (surface.time[to] - surface.time[number]) : 500;
      go(to);
      await show();
      if (timer) timer = setTimeout(next, Math.max(0, due - (performance.now() - begun)));
    };
    play.type = 'button';
    play.className = 'play';
    play.addEventListener('click', () => {
      if (timer) { stop(); return; }
      play.textContent = '❚❚ pause';
      play.setAttribute('aria-pressed', 'true');
      if (number === surface.frames.length - 1) go(0);
      timer = setTimeout(next, 0);
    });
    label.className = 'frames';
    Object.assign(input, { type: 'range', min: 0, max: surface.frames.length - 1, step: 1, value: number });
    input.setAttribute('aria-label', 'Time of the map');
    let waiting = 0;
    input.addEventListener('input', () => {
      stop();
      go(Number(input.value));
      cancelAnimationFrame(waiting);
      waiting = requestAnimationFrame(show);
    });
    label.append('Moment ', input, ' ', words);
    choices.append(play, label);
    stop();
    press();
    tell();
    show();
    return { show, frame: () => number };
  }

  function caption(surface) {
    const steeper = steepened(surface), gaps = surface.frames.some((_, number) => frame_of(surface, number).some(Number.isNaN));
    const last = surface.time.length - 1, span = figures.significant(surface.time[last] - surface.time[0]), step = (surface.time[last] - surface.time[0]) / last;
    return `The free surface from above, the flow to the right: ${surface.frames.length} maps, ${figures.significant(step)} s apart, of ${surface.earlier_left_out ? 'the last ' : ''}${span} s ` +
      '(at first the last one), each about its own mean; played at half speed. ' +
      (surface.velocity && surface.periodic_along ? `Ring: a point that moves at the depth-mean velocity, ${figures.significant(surface.velocity)} m/s: what keeps pace with it is carried along by the water, what overtakes it or falls behind is a wave. ` : '') +
      `Relief: light from the upper left${steeper > 1 ? ` on slopes drawn ${steeper} times as steep` : ''}, without what is shorter than four points of the map.` +
      (gaps ? ' Grey: no water.' : '');
  }

  // The map of the moment shown as CSV, SI.
  function csv(surface, number) {
    const values = frame_of(surface, number), nx = surface.x.length;
    return save.comment(`Elevation of the free surface about its mean over the plan, t = ${surface.time[number]} s`) +
      save.rows([[save.heading('x', 'm'), save.heading('y', 'm'), save.heading('elevation', 'm')], ...Array.from(values, (value, i) => [surface.x[i % nx], surface.y[Math.floor(i / nx)], value])]);
  }

  return { draw, paint, caption, csv };
})();
