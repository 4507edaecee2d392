'use strict';
(function () {
  const data = JSON.parse(document.getElementById('data').textContent);
  const tip = document.getElementById('tip');
  const plan = document.getElementById('plan');
  const here = document.getElementById('here');

  // What <title> says, told at once, also to fingers.
  function show(element, x, y) {
    tip.textContent = element.dataset.tip;
    tip.hidden = false;
    tip.style.left = Math.max(4, Math.min(x + 14, window.innerWidth - tip.offsetWidth - 4)) + 'px';
    tip.style.top = Math.max(4, Math.min(y + 14, window.innerHeight - tip.offsetHeight - 4)) + 'px';
  }
  for (const element of plan ? plan.querySelectorAll('polygon, circle, .room, .door') : []) {
    const title = element.querySelector('title');
    if (!title) continue;
    element.dataset.tip = title.textContent;
    element.setAttribute('aria-label', title.textContent);
    title.remove();
    element.addEventListener('pointermove', event => show(element, event.clientX, event.clientY));
    element.addEventListener('pointerdown', event => show(element, event.clientX, event.clientY));
    element.addEventListener('pointerleave', event => { if (event.pointerType === 'mouse') tip.hidden = true; });
    element.addEventListener('focus', () => {
      const box = element.getBoundingClientRect();
      show(element, box.right, box.bottom);
    });
    element.addEventListener('blur', () => { tip.hidden = true; });
  }
  document.addEventListener('scroll', () => { tip.hidden = true; }, {passive: true});

  // The place at a time: the pose nearest to it.
  function markPlace(time) {
    if (!here || data.way.length === 0) return;
    let low = 0, high = data.way.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (data.way[middle][0] > time) high = middle; else low = middle;
    }
    const pose = time - data.way[low][0] < data.way[high][0] - time ? data.way[low] : data.way[high];
    here.setAttribute('cx', pose[1]);
    here.setAttribute('cy', pose[2]);
    here.setAttribute('visibility', Math.abs(pose[0] - time) < 1 ? 'visible' : 'hidden');
  }

  if (typeof Dygraph === 'undefined') return;
  const ofPage = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const short = value => String(Number(value.toPrecision(3)));
  const graphs = [];
  let isPassingOn = false;
  function passOn(from, action) {
    if (isPassingOn) return;
    isPassingOn = true;
    for (const graph of graphs) if (graph !== from) action(graph);
    isPassingOn = false;
  }
  function shadeLost(canvas, area, graph) {
    canvas.fillStyle = ofPage('--lost');
    for (const [from, to] of data.lost) {
      const left = graph.toDomXCoord(from);
      canvas.fillRect(left, area.y, Math.max(2, graph.toDomXCoord(to) - left), area.h);
    }
  }
  for (const plot of data.plots) {
    const place = document.getElementById('plot-' + plot.id);
    if (!place) continue;
    graphs.push(new Dygraph(place, plot.rows, {
      labels: ['time'].concat(plot.lines),
      labelsDiv: 'legend-' + plot.id,
      legend: 'always',
      colors: ['#3b82f6', '#16a34a', '#e8590c'],
      strokeWidth: 1.5,
      gridLineColor: ofPage('--line'),
      axisLineColor: ofPage('--line'),
      includeZero: true,
      connectSeparatedPoints: true,
      axes: {x: {valueFormatter: value => value.toFixed(2) + ' s'}, y: {axisLabelWidth: 48, axisLabelFormatter: short, valueFormatter: short}},
      underlayCallback: shadeLost,
      highlightCallback: (event, x, points, row) => {
        markPlace(x);
        passOn(event.target && graphs.find(graph => graph.graphDiv.contains(event.target)),
               graph => { const at = graph.getRowForX(x); if (at !== null) graph.setSelection(at); });
      },
      unhighlightCallback: () => { if (here) here.setAttribute('visibility', 'hidden'); },
      zoomCallback: (from, to) => {
        passOn(null, graph => graph.updateOptions({dateWindow: [from, to]}));
      }
    }));
  }
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
    for (const graph of graphs) {
      graph.updateOptions({gridLineColor: ofPage('--line'), axisLineColor: ofPage('--line')});
    }
  });
})();
