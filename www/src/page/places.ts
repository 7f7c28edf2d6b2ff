// What a reader has before the eyes when the page is made anew: where everything is scrolled to and what has the focus.

/** Remembers it; the returned function brings it back into the new page. */
export function keepPlaces(): () => void {
  const scrolled = [...document.body.querySelectorAll<HTMLElement>("*")]
    .filter(node => node.scrollTop !== 0 || node.scrollLeft !== 0)
    .map(node => ({
      area: node.closest("[id]")?.id ?? "",
      className: node.className,
      left: node.scrollLeft,
      top: node.scrollTop,
    }));
  const focused = document.activeElement?.id;
  return () => {
    for (const { area, className, left, top } of scrolled) {
      const within = document.getElementById(area);
      const node = within?.className === className ? within : within?.getElementsByClassName(className)[0];
      node?.scrollTo({ left, top, behavior: "instant" });
    }
    if (focused) document.getElementById(focused)?.focus({ preventScroll: true });
  };
}
