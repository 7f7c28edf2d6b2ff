// What both modules of the core need: fetching, compiling, and a problem that is told apart.

/** The core broke: a bug, never a wrong input. After it no call is safe. */
export class Broken extends Error {}

export function call<T>(name: string, run: () => T): T {
  try {
    return run();
  } catch (problem) {
    throw new Broken(`${name}: ${problem instanceof Error ? problem.message : String(problem)}`, { cause: problem });
  }
}

/** Compiled while it comes, where the server says what it is. */
export async function compile(address: string): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  const served = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return served ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
