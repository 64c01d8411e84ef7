// Colour scales: one for numbers of one sign, one for numbers around zero.
import { CanvasTexture, LinearFilter, SRGBColorSpace } from "three";

// viridis (N. Smith, S. van der Walt, CC0) without its dark end, where shading would be lost, and cool-warm (K. Moreland, 2009), at equal distances.
const SEQUENTIAL = ["#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"];
const DIVERGING = ["#3b4cc0", "#6282ea", "#8db0fe", "#b8d0f9", "#dddddd", "#f5c4ad", "#f49a7b", "#de604d", "#b40426"];

export const is_signed = (low, high) => low < 0 && high > 0 && Math.min(-low, high) > 0.1 * Math.max(-low, high);

function paint(canvas, stops, upwards) {
  const context = canvas.getContext("2d");
  const { width, height } = canvas;
  const gradient = upwards ? context.createLinearGradient(0, height, 0, 0) : context.createLinearGradient(0, 0, width, 0);
  stops.forEach((colour, i) => gradient.addColorStop(i / (stops.length - 1), colour));
  context.fillStyle = gradient;
  context.fillRect(0, 0, width, height);
}

/** The part of the scale that low ... high covers: that around zero has its middle at zero. */
function stops_of(low, high) {
  return is_signed(low, high) ? DIVERGING : SEQUENTIAL;
}

export function paint_bar(canvas, low, high) {
  paint(canvas, stops_of(low, high), true);
}

/** A row of 256 colours. */
export function colour_texture(low, high) {
  const canvas = document.createElement("canvas");
  canvas.width = 256;
  canvas.height = 1;
  paint(canvas, stops_of(low, high), false);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.generateMipmaps = false;
  return texture;
}
