// A solid as it is drawn, and how it looks.
import type { Line, Mesh, Paint, Style } from "./mesh";

export interface Part {
  mesh: Mesh;
  edges: Line[];
}
/** `pieces`: into how many a long face is cut. */
export interface Look {
  paint: Paint;
  edge: Style;
  pieces: number;
}
