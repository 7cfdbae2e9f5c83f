// The player's state: time, speed, loop and selection. It knows no page and no drawing.

export class Player {
  constructor(duration, fps) {
    Object.assign(this, { duration, fps, time: 0, speed: 1, playing: false, looping: true, selection: null });
  }

  get frame() { return Math.round(this.time * this.fps); }
  get lastFrame() { return Math.round(this.duration * this.fps); }

  seek(t) { this.time = Math.min(Math.max(t, 0), this.duration); }

  /** Steps by whole frames and stops there. */
  step(frames) {
    this.playing = false;
    this.seek(Math.min(Math.max(this.frame + frames, 0), this.lastFrame) / this.fps);
  }

  toggle() {
    if (!this.playing && !this.looping && this.time >= this.duration) this.time = 0;
    this.playing = !this.playing;
  }

  /** Moves on by `seconds` of the clock; loops over the selected value, or else over the whole. */
  advance(seconds) {
    if (!this.playing) return;
    const inside = this.looping && this.selection && this.selection.end > this.selection.start;
    const from = inside ? this.selection.start : 0, to = inside ? this.selection.end : this.duration;
    let t = this.time + seconds * this.speed;
    if (t >= to || t < from) {
      if (!this.looping) { t = to; this.playing = false; }
      else t = to > from ? from + (((t - from) % (to - from)) + (to - from)) % (to - from) : from;
    }
    this.time = t;
  }
}
