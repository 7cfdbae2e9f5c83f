// The timeline: a ruler, the wrist speeds, and the tiers, on two canvases with one time scale.
import { roundStep } from './speed.js';

const ROW = 21, RULER = 17;
const hand = (name) => (/^(RH|right)\b/i.test(name) ? 'right' : /^(LH|left)\b/i.test(name) ? 'left' : 'both');

export class Timeline {
  /** `seek(t)` is called with seconds while scrubbing, `select(value)` with the clicked value or null. */
  constructor({ tiers, duration, speeds, seek, select }) {
    this.tiers = tiers.filter((tier) => tier.values.length > 0);
    Object.assign(this, { duration, speeds, seek, select, from: 0, to: duration, now: 0, selected: null });
    this.curves = document.getElementById('curves');
    this.rows = document.getElementById('tiers');
    this.tip = document.getElementById('tip');
    this.rows.style.height = `${this.tiers.length * ROW + 5}px`;
    for (const canvas of [this.curves, this.rows]) this.listen(canvas);
    this.readColours();
  }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    this.colour = (name) => style.getPropertyValue(`--${name}`).trim();
  }

  get gutter() { return this.rows.clientWidth < 560 ? 106 : 138; }
  x(t) { return this.gutter + (t - this.from) / (this.to - this.from) * (this.rows.clientWidth - this.gutter - 10); }
  time(x) {
    const share = (x - this.gutter) / (this.rows.clientWidth - this.gutter - 10);
    return Math.min(Math.max(this.from + share * (this.to - this.from), 0), this.duration);
  }

  /** Shows `factor` times as much, keeping the moment `around` (seconds) where it is. */
  zoom(factor, around = this.now) {
    const span = Math.min(Math.max((this.to - this.from) * factor, Math.min(0.1, this.duration)), this.duration);
    const share = (around - this.from) / (this.to - this.from);
    this.show(around - share * span, span);
  }

  show(from, span) {
    this.from = Math.min(Math.max(from, 0), this.duration - span);
    this.to = this.from + span;
    this.draw();
  }

  /** Moves the playhead to `t` seconds, turning the page when it leaves the shown part. */
  move(t) {
    this.now = t;
    const span = this.to - this.from;
    if (t < this.from - 1e-9 || t > this.to + 1e-9) return this.show(t - span * 0.05, span);
    this.draw();
  }

  valueAt(event) {
    if (event.currentTarget !== this.rows && event.target !== this.rows) return null;
    const tier = this.tiers[Math.floor((event.offsetY - 2) / ROW)];
    if (!tier || event.offsetX < this.gutter) return null;
    const t = this.time(event.offsetX);
    const value = tier.values.find((v) => t >= v.start && t < Math.max(v.end, v.start + 1e-3));
    return value ? { tier: tier.name, ...value } : null;
  }

  listen(canvas) {
    let start = null;
    canvas.addEventListener('pointerdown', (event) => {
      start = { x: event.offsetX, value: this.valueAt(event), dragged: false };
      canvas.setPointerCapture(event.pointerId);
      if (!start.value) this.seek(this.time(event.offsetX));
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!start) return this.hover(event);
      if (Math.abs(event.offsetX - start.x) > 3) start.dragged = true;
      if (start.dragged) this.seek(this.time(event.offsetX));
    });
    canvas.addEventListener('pointerup', () => {
      if (start && !start.dragged) {
        this.select(start.value);
        if (start.value) this.seek(start.value.start);
      }
      start = null;
    });
    canvas.addEventListener('pointercancel', () => { start = null; });
    canvas.addEventListener('pointerleave', () => { this.tip.hidden = true; });
    canvas.addEventListener('wheel', (event) => {
      if (event.ctrlKey) this.zoom(event.deltaY > 0 ? 1.25 : 0.8, this.time(event.offsetX));
      else if (event.deltaX) this.show(this.from + event.deltaX / 600 * (this.to - this.from), this.to - this.from);
      else return;
      event.preventDefault();
    }, { passive: false });
  }

  hover(event) {
    const value = this.valueAt(event);
    this.tip.hidden = !value;
    if (!value) return;
    const span = `${value.start.toFixed(3)}–${value.end.toFixed(3)} s (${(value.end - value.start).toFixed(3)} s)`;
    this.tip.textContent = [`${value.tier}: ${value.label}`, span, value.source && `from ${value.source}`].filter(Boolean).join('\n');
    const home = document.getElementById('timeline').getBoundingClientRect();
    this.tip.style.left = `${Math.max(Math.min(event.clientX - home.left + 12, home.width - this.tip.offsetWidth - 6), 4)}px`;
    this.tip.style.top = `${event.clientY - home.top - this.tip.offsetHeight - 10}px`;
  }

  /** Clears a canvas to its size on screen and returns its pen, width and height in CSS pixels. */
  pen(canvas) {
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const pen = canvas.getContext('2d');
    pen.scale(ratio, ratio);
    pen.font = '12px system-ui, "DejaVu Sans", sans-serif';
    pen.textBaseline = 'middle';
    return [pen, width, height];
  }

  draw() {
    this.drawCurves(...this.pen(this.curves));
    this.drawTiers(...this.pen(this.rows));
  }

  playhead(pen, height, top = 0) {
    const x = this.x(this.now);
    if (x < this.gutter - 1) return;
    pen.fillStyle = this.colour('accent');
    pen.fillRect(x - 0.75, top, 1.5, height - top);
  }

  shade(pen, height) {
    if (!this.selected) return;
    pen.fillStyle = this.colour('accent');
    pen.globalAlpha = 0.13;
    pen.fillRect(this.x(this.selected.start), 0, this.x(this.selected.end) - this.x(this.selected.start), height);
    pen.globalAlpha = 1;
  }

  drawCurves(pen, width, height) {
    const { right, left, step, top } = this.speeds, gutter = this.gutter;
    const bottom = height - 4, ceiling = RULER + 5;
    pen.save();
    pen.beginPath(); pen.rect(gutter - 1, 0, width - gutter - 6, height); pen.clip();
    this.shade(pen, height);
    const every = roundStep(this.to - this.from, (width - gutter) / 90);
    const decimals = Math.max(0, -Math.floor(Math.log10(every) + 1e-9));
    for (let k = Math.ceil(this.from / every - 1e-9); k * every <= this.to + 1e-9; k++) {
      pen.fillStyle = this.colour('line');
      pen.fillRect(this.x(k * every), 4, 1, height);
      pen.fillStyle = this.colour('muted');
      pen.fillText((k * every).toFixed(decimals), this.x(k * every) + 4, 10);
    }
    pen.restore();

    // The speeds' scale: the highest speed in the animation, in round steps.
    const grid = roundStep(Math.max(top, 0.1), 2.4), most = Math.max(top * 1.04, 0.1);
    const y = (speed) => bottom - speed / most * (bottom - ceiling);
    pen.textAlign = 'right';
    for (let k = 0; k * grid <= most; k++) {
      pen.fillStyle = this.colour('line');
      pen.fillRect(gutter, Math.round(y(k * grid)), width - gutter - 10, 1);
      pen.fillStyle = this.colour('muted');
      pen.fillText(String(+(k * grid).toFixed(3)), gutter - 5, Math.min(y(k * grid), height - 6));
    }
    pen.textAlign = 'left';
    [['right wrist', right, 'right'], ['left wrist', left, 'left']].forEach(([name, values, colour], row) => {
      pen.fillStyle = pen.strokeStyle = this.colour(colour);
      const now = values[Math.min(Math.round(this.now / step), values.length - 1)] || 0;
      pen.fillText(gutter > 100 ? `${name} ${now.toFixed(2)}` : name, 8, ceiling + 14 + row * 17);
      pen.save();
      pen.beginPath(); pen.rect(gutter, 0, width - gutter - 10, height); pen.clip();
      pen.beginPath();
      const first = Math.max(Math.floor(this.from / step) - 1, 0), last = Math.min(Math.ceil(this.to / step) + 1, values.length - 1);
      for (let i = first; i <= last; i++) pen.lineTo(this.x(i * step), y(values[i]));
      pen.lineWidth = 1.6;
      pen.stroke();
      pen.restore();
    });
    pen.fillStyle = this.colour('muted');
    pen.fillText('speed, m/s', 8, 10);
    this.playhead(pen, height, 3);
  }

  drawTiers(pen, width, height) {
    const gutter = this.gutter, edge = width - 10;
    this.tiers.forEach((tier, row) => {
      const side = hand(tier.name), top = 2 + row * ROW;
      pen.fillStyle = this.colour(side);
      pen.fillText(tier.name, 8, top + ROW / 2, gutter - 14);
      pen.fillStyle = this.colour('track');
      pen.fillRect(gutter, top + 1, edge - gutter, ROW - 2);
      pen.save();
      pen.beginPath(); pen.rect(gutter, top, edge - gutter, ROW); pen.clip();
      for (const value of tier.values) {
        const a = Math.max(this.x(value.start), gutter - 4), b = Math.min(this.x(value.end), edge + 4);
        if (b < gutter || a > edge) continue;
        const current = this.now >= value.start && this.now < value.end;
        pen.fillStyle = this.colour(current ? side : `${side}-fill`);
        pen.beginPath();
        pen.roundRect(a + 0.75, top + 1.5, Math.max(b - a - 1.5, 1.5), ROW - 3, 3);
        pen.fill();
        if (this.selected && this.selected.tier === tier.name && this.selected.start === value.start) {
          pen.strokeStyle = this.colour('accent');
          pen.lineWidth = 2;
          pen.stroke();
        }
        if (b - a < 12) continue;
        pen.save();
        pen.clip();
        pen.fillStyle = this.colour(current ? 'panel' : 'fg');
        pen.fillText(value.label, a + 6, top + ROW / 2 + 0.5);
        pen.restore();
      }
      pen.restore();
    });
    pen.save();
    pen.beginPath(); pen.rect(gutter, 0, edge - gutter, height); pen.clip();
    this.shade(pen, height);
    pen.restore();
    this.playhead(pen, height);
  }
}
