// How sharp pictures are while the body turns: less where they would be slow, as without a graphics processor.

const LONGEST = 20; // [ms] that such a picture may take; the browser needs time, too, to put it on the screen

/** Share of the pixels along each side, and bits of the places of vertices (0: all), see `Surface.simplify`. */
const LEVELS = [
  { share: 1, bits: 0 }, { share: 1, bits: 6 }, { share: 0.6, bits: 6 }, { share: 0.6, bits: 5 }, { share: 0.35, bits: 5 },
];

export class Sharpness {
  constructor(gl) {
    this.gl = gl;
    this.is_turning = false;
    this.level_of_turns = 0;
    this.pixel = new Uint8Array(4);
  }

  /** Of the next picture. */
  get level() {
    return LEVELS[this.is_turning ? this.level_of_turns : 0];
  }

  /** Draws a picture. The time that one takes while the body turns decides how sharp the next such picture is. */
  around(draw) {
    const start = performance.now();
    draw();
    if (!this.is_turning) return;
    // Waits for the picture: browsers draw in another process.
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, this.pixel);
    const taken = performance.now() - start;
    const change = taken > 4 * LONGEST ? 2 : taken > LONGEST ? 1 : taken < LONGEST / 4 ? -1 : 0;
    this.level_of_turns = Math.min(Math.max(this.level_of_turns + change, 0), LEVELS.length - 1);
  }
}
