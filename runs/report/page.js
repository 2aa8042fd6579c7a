// SPDX-License-Identifier: Apache-2.0
// Draws the page's charts; colours of axes and text are the style sheet's.
(() => {
  'use strict';
  const font = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif';
  const config = {
    background: null,
    font,
    view: {stroke: null},
    axis: {
      labelFontSize: 11, titleFontSize: 12, titleFontWeight: 500, titlePadding: 8,
      labelPadding: 5, gridDash: [2, 3], domain: false, ticks: false, labelLimit: 220,
      titleLimit: 400,
    },
    axisX: {
      domain: true, ticks: true, tickSize: 4, grid: false, tickCount: {signal: 'ceil(width / 80)'},
    },
    axisYQuantitative: {tickCount: {signal: 'ceil(height / 48)'}},
    legend: {
      orient: 'top', direction: 'horizontal', title: null, labelFontSize: 12, symbolSize: 90,
      symbolStrokeWidth: 2.5, offset: 6, columnPadding: 18, labelLimit: 260,
    },
    title: {anchor: 'start', fontSize: 13, fontWeight: 600, offset: 10},
    line: {strokeWidth: 1.8, strokeJoin: 'round'},
    boxplot: {size: 18},
  };

  const draw = async (chart) => {
    if (chart.dataset.state) return;
    chart.dataset.state = 'drawing';
    const plot = chart.querySelector('.plot');
    try {
      const spec = JSON.parse(chart.querySelector('script').textContent);
      const compiled = vegaLite.compile(spec, {config}).spec;
      delete compiled.$schema;  // names a version only to warn about it
      await vegaEmbed(plot, compiled, {mode: 'vega', renderer: 'svg', actions: false});
      chart.dataset.state = 'drawn';
    } catch (error) {
      chart.dataset.state = 'failed';
      plot.textContent = 'This chart could not be drawn: ' + error.message;
    }
  };

  // A chart takes the width of its place, and in closed details there is none.
  const visible = (chart) => !chart.closest('details:not([open])');
  const draw_visible = () =>
      Promise.all([...document.querySelectorAll('figure.chart')].filter(visible).map(draw));
  document.querySelectorAll('details').forEach(
      (details) => details.addEventListener('toggle', draw_visible));
  window.addEventListener('beforeprint', () => {
    document.querySelectorAll('details').forEach((details) => { details.open = true; });
  });
  draw_visible();

  // Where the reader is, marked in the contents.
  const entries = new Map([...document.querySelectorAll('nav a')].map(
      (link) => [link.getAttribute('href').slice(1), link]));
  if (entries.size && 'IntersectionObserver' in window) {
    const seen = new Set();
    const observer = new IntersectionObserver((changes) => {
      for (const {target, isIntersecting} of changes) {
        if (isIntersecting) seen.add(target.id); else seen.delete(target.id);
      }
      let current = null;
      for (const [id, link] of entries) {
        link.removeAttribute('aria-current');
        if (!current && seen.has(id)) current = link;
      }
      if (current) current.setAttribute('aria-current', 'true');
    }, {rootMargin: '-10% 0px -60% 0px'});
    document.querySelectorAll('main > section').forEach((section) => observer.observe(section));
  }
})();
