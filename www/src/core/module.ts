// The core as a module: fetching, compiling, and a problem that is told apart.

/** The core broke: a bug, never a wrong input. After it no call is safe. */
export class Broken extends Error {}

/** What the core said of it, without the name of the question. */
export function reasonOf(problem: unknown): string {
  const said = problem instanceof Broken ? problem.cause : problem;
  return said instanceof Error ? said.message : String(said);
}

export function call<T>(name: string, run: () => T): T {
  try {
    return run();
  } catch (problem) {
    throw new Broken(`${name}: ${problem instanceof Error ? problem.message : String(problem)}`, { cause: problem });
  }
}

const coming = new Map<string, Promise<WebAssembly.Module>>();

/** A module, which is fetched once; where that fails, whoever asks next tries again. */
export function compile(address: string): Promise<WebAssembly.Module> {
  const module = coming.get(address) ?? compiled(address);
  coming.set(address, module);
  module.catch(() => coming.delete(address));
  return module;
}

/** Compiled while it comes, where the server says what it is. */
async function compiled(address: string): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  const served = response.headers.get("Content-Type")?.startsWith("application/wasm");
  return served ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
