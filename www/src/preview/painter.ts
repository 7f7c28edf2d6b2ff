// When the picture is drawn: once a frame at most, and never when nothing changed.
export interface Painter {
  /** With the next frame. */
  soon(): void;
  /** In this frame of the page, once everything of it is told. */
  now(): void;
  /** Never again. */
  end(): void;
}

export function createPainter(draw: () => void): Painter {
  let frame = 0; // under way
  let telling = false;
  let ended = false;
  const paint = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    draw();
  };
  return {
    soon() {
      if (!frame && !ended) frame = requestAnimationFrame(paint);
    },
    now() {
      if (telling) return;
      telling = true;
      queueMicrotask(() => {
        telling = false;
        if (!ended) paint();
      });
    },
    end() {
      ended = true;
      cancelAnimationFrame(frame);
    },
  };
}
