// A coarse depth picture on the processor, so that lines know where they are behind a part.
import type { Projected, Viewport } from "./camera";

const CELL = 2; // CSS pixels

/** Nearest surface a cell, mm towards the viewer. */
export interface Depth {
  columns: number;
  rows: number;
  near: Float64Array;
}

export function emptyDepth({ width, height }: Viewport): Depth {
  const [columns, rows] = [Math.ceil(width / CELL), Math.ceil(height / CELL)];
  return { columns, rows, near: new Float64Array(columns * rows).fill(-Infinity) };
}

/** Enters a triangle at the cells whose middle it covers. */
export function cover(depth: Depth, [a, b, c]: [Projected, Projected, Projected]): void {
  const area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (area === 0) return;
  const [x0, x1] = cells(depth.columns, a.x, b.x, c.x);
  const [y0, y1] = cells(depth.rows, a.y, b.y, c.y);
  for (let row = y0; row <= y1; row++) {
    const y = (row + 0.5) * CELL;
    for (let column = x0; column <= x1; column++) {
      const x = (column + 0.5) * CELL;
      const u = ((x - a.x) * (c.y - a.y) - (c.x - a.x) * (y - a.y)) / area;
      const v = ((b.x - a.x) * (y - a.y) - (x - a.x) * (b.y - a.y)) / area;
      if (u < 0 || v < 0 || u + v > 1) continue;
      const cell = row * depth.columns + column;
      const near = a.near + u * (b.near - a.near) + v * (c.near - a.near);
      if (near > depth.near[cell]!) depth.near[cell] = near;
    }
  }
}

function cells(count: number, ...at: number[]): [number, number] {
  const first = Math.floor(Math.min(...at) / CELL - 0.5);
  const last = Math.ceil(Math.max(...at) / CELL - 0.5);
  return [Math.max(0, first), Math.min(count - 1, last)];
}

/** Whether a point lies behind a surface by more than `slack` mm, in its own cell and all around it. */
export function hidden(depth: Depth, { x, y, near }: Projected, slack: number): boolean {
  const [column, row] = [Math.floor(x / CELL), Math.floor(y / CELL)];
  for (let dy = -1; dy <= 1; dy++) {
    for (let dx = -1; dx <= 1; dx++) {
      if (!covered(depth, column + dx, row + dy, near + slack)) return false;
    }
  }
  return true;
}

function covered({ columns, rows, near }: Depth, column: number, row: number, than: number): boolean {
  const inside = column >= 0 && column < columns && row >= 0 && row < rows;
  return inside && near[row * columns + column]! > than;
}
