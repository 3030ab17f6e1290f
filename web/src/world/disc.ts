import { CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace } from "three";

/** A colored disc, or a square, with a letter, before everything else. */
export function disc(letter: string, color: string, order: number, isSquare = false): Sprite {
  const size = 64; // [px]
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = size;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.fillStyle = color;
    pen.beginPath();
    if (isSquare) pen.rect(5, 5, size - 10, size - 10);
    else pen.arc(size / 2, size / 2, size / 2 - 2, 0, 2 * Math.PI);
    pen.fill();
    pen.fillStyle = "#ffffff";
    pen.font = `600 ${0.62 * size}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillText(letter, size / 2, 0.53 * size);
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, toneMapped: false }));
  sprite.renderOrder = order;
  return sprite;
}
