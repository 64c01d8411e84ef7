// How sharp pictures are while the body turns: less where they would be slow, as without a graphics processor.
// Such pictures have fewer pixels, and surfaces have fewer triangles.

const LONGEST = 33; // [ms] that a picture may take
const LEAST = 0.3;

export class Sharpness {
  constructor(gl) {
    this.gl = gl;
    this.share = 1; // of the pixels along each side of the full picture
    this.is_turning = false;
    this.pixel = new Uint8Array(4);
  }

  start() {
    this.is_turning = true;
  }

  /** Of the places of vertices: 0 for all. */
  get bits() {
    if (this.share === 1) return 0;
    return this.share > LEAST ? 6 : 5;
  }

  /** Full sharpness again; true where it was less. */
  end() {
    const was_less = this.share < 1;
    this.is_turning = false;
    this.share = 1;
    return was_less;
  }

  /** Draws a picture, and lowers the share of pixels for the next one where this one takes too long. */
  around(draw) {
    const start = performance.now();
    draw();
    if (!this.is_turning || this.share <= LEAST) return;
    // Waits for the picture: browsers draw in another process.
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, this.pixel);
    const taken = performance.now() - start;
    if (taken > LONGEST) this.share = Math.max(LEAST, this.share * Math.max(0.5, Math.sqrt(LONGEST / taken)));
  }
}
