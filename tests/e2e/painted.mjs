// What a press costs the page itself, for the benchmarks: they ask for it in the page.

/**
 * Gives the page `workOf(press)`: ms of its own work from a press, made by a function, to the layout of the frame that
 * shows what came of it.
 */
export async function givesWork(page) {
  await page.evaluate(() => {
    globalThis.workOf = async press => {
      const before = new Promise(resolve => requestAnimationFrame(() => resolve(performance.now())));
      const pressed = performance.now();
      press();
      const handled = performance.now() - pressed;
      const drawn = new Promise(resolve =>
        requestAnimationFrame(() => {
          void document.body.offsetHeight;
          resolve(performance.now());
        }),
      );
      const [began, ended] = await Promise.all([before, drawn]);
      return handled + ended - began;
    };
  });
}
