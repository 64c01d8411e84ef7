// The frames of a run, as the program packs them (engine/report/packed_frames.cpp): each frame is one
// element of the page with base64 of a zlib stream. The stream holds arrays one after another, each as
// differences of its numbers from a prediction, low bytes first.

const SPATIAL = 0; // from the number before in the same array; else from the same number a frame before

function bytes_of(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  /**
   * `count` numbers into an array of the given type, predicted from `before` where the stream says. Their
   * lowest `shift` bits are not in the stream.
   */
  numbers(Type, count, before, shift) {
    const { bytes } = this;
    const planes = Type.BYTES_PER_ELEMENT;
    const mask = planes === 2 ? 0xffff : -1;
    const prediction = bytes[this.at++];
    const values = new Type(count);
    const start = this.at;
    let last = 0;
    for (let i = 0; i < count; ++i) {
      let code = 0;
      for (let p = 0; p < planes; ++p) code |= bytes[start + p * count + i] << (8 * p);
      code >>>= 0;
      const difference = (code >>> 1) ^ -(code & 1);
      last = ((prediction === SPATIAL ? last : before[i] >>> shift) + difference) & mask;
      values[i] = last << shift;
    }
    this.at += planes * count;
    return values;
  }
}

/** Points of one kind in one frame: { count, position: [x, y, z], values: [field][point], pieces }. */
function points_of(reader, set, index, { fields, shift }, before) {
  const count = set.points[index];
  const read = (old) => reader.numbers(Uint16Array, count, old, shift);
  const position = [0, 1, 2].map((axis) => read(before?.position[axis]));
  const values = fields.map((_, f) => read(before?.values[f]));
  const frame = { count, position, values };
  if (set.corners) {
    frame.pieces = set.same[index]
      ? before.pieces
      : reader.numbers(Uint32Array, set.pieces[index] * set.corners, null, 0);
  }
  return frame;
}

export class Frames {
  constructor(run) {
    this.run = run;
    this.elements = [...document.querySelectorAll("script.frame")];
    this.loaded = []; // [frame][set]
    this.waiting = new Map();
  }

  get count() {
    return this.run.times.length;
  }

  /** Unpacks all frames in order, and calls `progress` after each. */
  async load(progress) {
    for (let index = 0; index < this.count; ++index) {
      const text = this.elements[index].textContent.trim();
      this.elements[index].textContent = "";
      const reader = new Reader(await inflated(bytes_of(text)));
      this.loaded.push(
        this.run.sets.map((set, s) =>
          points_of(reader, set, index, this.run, this.loaded[index - 1]?.[s])),
      );
      progress(index);
      await new Promise((resume) => setTimeout(resume));
    }
  }

  /** The sets of a frame, or of the last one that has been loaded. */
  at(index) {
    return this.loaded[Math.min(index, this.loaded.length - 1)];
  }
}
