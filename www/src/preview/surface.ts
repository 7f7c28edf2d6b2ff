// Free surfaces: heights over a grid, or triangles.
import type { Surface, Vec3 } from "../wire";
import { type Line, mesh, triangle } from "./mesh";
import type { Look, Part } from "./part";
import { cross, sub, unit } from "./vec";

export function surface(shape: Surface, look: Look): Part {
  return "heights" in shape ? relief(shape.heights, look) : faceted(shape.triangles, look);
}

/** A grid of heights, shaded smoothly, with its border. */
function relief({ columns, step, values }: Extract<Surface, { heights: unknown }>["heights"], look: Look): Part {
  const rows = Math.floor(values.length / columns);
  const height = (column: number, row: number): number =>
    values[Math.min(Math.max(row, 0), rows - 1) * columns + Math.min(Math.max(column, 0), columns - 1)] ?? 0;
  const at = (column: number, row: number): Vec3 => [
    (column - (columns - 1) / 2) * step[0],
    (row - (rows - 1) / 2) * step[1],
    height(column, row),
  ];
  const normal = (column: number, row: number): Vec3 =>
    unit([
      (height(column - 1, row) - height(column + 1, row)) / (2 * step[0]),
      (height(column, row - 1) - height(column, row + 1)) / (2 * step[1]),
      1,
    ]);
  const own: Part = { mesh: mesh(), edges: [] };
  const add = (corners: [[number, number], [number, number], [number, number]]): void => {
    const [a, b, c] = corners;
    triangle(own.mesh, [at(...a), at(...b), at(...c)], [normal(...a), normal(...b), normal(...c)], look.paint);
  };
  for (let row = 1; row < rows; row++) {
    for (let column = 1; column < columns; column++) {
      const [first, last]: [[number, number], [number, number]] = [
        [column - 1, row - 1],
        [column, row],
      ];
      add([first, [column, row - 1], last]);
      add([first, last, [column - 1, row]]);
    }
  }
  const line = (from: Vec3, to: Vec3): Line => ({ from, to, style: look.edge });
  for (let column = 1; column < columns; column++)
    for (const row of [0, rows - 1]) own.edges.push(line(at(column - 1, row), at(column, row)));
  for (let row = 1; row < rows; row++)
    for (const column of [0, columns - 1]) own.edges.push(line(at(column, row - 1), at(column, row)));
  return own;
}

/** Triangles, each flat. */
function faceted(triangles: [Vec3, Vec3, Vec3][], look: Look): Part {
  const own: Part = { mesh: mesh(), edges: [] };
  for (const corners of triangles) {
    const across = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]));
    if (across.every(value => value === 0)) continue;
    const normal = unit(across);
    triangle(own.mesh, corners, [normal, normal, normal], look.paint);
  }
  return own;
}
