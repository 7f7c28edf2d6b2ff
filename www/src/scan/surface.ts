// A surface of the user's: an STL file as it is, or a picture whose grey values are heights. The browser decodes
// pictures.

import { type Refusal, tooLarge } from "../state/files";
import type { SurfaceChoice } from "../wire";

export interface SurfaceFile {
  name: string;
  choice: SurfaceChoice;
  bytes: Uint8Array;
}

const LARGEST = 64e6; // bytes
const LARGEST_SIDE = 700; // grey values along the longer side of a picture; a larger one is made smaller
const GREY = [0.299, 0.587, 0.114] as const; // brightness of red, green, blue

/** A file that is not taken. */
export class NotTaken extends Error {
  constructor(readonly refusal: Refusal) {
    super(refusal.key);
  }
}

function noSurface(file: File): NotTaken {
  return new NotTaken({ key: "scan-file-sort", args: { name: file.name } });
}

export async function readSurface(file: File): Promise<SurfaceFile> {
  if (file.size > LARGEST) throw new NotTaken(tooLarge("scan-file-size", file, LARGEST));
  if (/\.stl$/i.test(file.name))
    return { name: file.name, choice: "stl", bytes: new Uint8Array(await file.arrayBuffer()) };
  const { greys, columns } = await picture(file);
  return { name: file.name, choice: { picture: columns }, bytes: greys };
}

async function picture(file: File): Promise<{ greys: Uint8Array; columns: number }> {
  const image = await createImageBitmap(file).catch(() => {
    throw noSurface(file);
  });
  const scale = Math.min(1, LARGEST_SIDE / Math.max(image.width, image.height));
  const [width, height] = [image.width, image.height].map(side => Math.max(2, Math.round(side * scale))) as [
    number,
    number,
  ];
  const context = new OffscreenCanvas(width, height).getContext("2d");
  if (!context) throw noSurface(file);
  context.fillStyle = "#fff"; // behind what is clear
  context.fillRect(0, 0, width, height);
  context.drawImage(image, 0, 0, width, height);
  const { data } = context.getImageData(0, 0, width, height);
  const greys = new Uint8Array(width * height);
  for (let i = 0; i < greys.length; i++) {
    greys[i] = GREY.reduce((sum, share, colour) => sum + share * (data[4 * i + colour] ?? 0), 0);
  }
  return { greys, columns: width };
}
