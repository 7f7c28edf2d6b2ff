// The best way of drawing that this browser has, and the next one when its device is gone.
import type { Backend, BackendName, Hooks } from "./backend";
import { openGpu } from "./gpu";
import { openSvg } from "./svg";

/** A way of drawing that this browser has not, and why. */
export interface Refusal {
  backend: BackendName;
  reason: string;
}

export interface Ways {
  readonly backend: Backend;
  readonly refused: readonly Refusal[];
  /** Its device is gone. */
  replace(reason: unknown): Promise<void>;
  end(): void;
}

/** Whom it tells: `replaced` when another way draws from now on, the rest as the backends do. */
export interface Told extends Omit<Hooks, "lost"> {
  replaced(): void;
}

const WAYS: BackendName[] = ["webgpu", "webgl2", "svg"]; // the best first

export async function openWays(stage: HTMLElement, told: Told): Promise<Ways> {
  const refused: Refusal[] = [];
  let replacing = false;
  let ended = false;
  const hooks: Hooks = {
    ...told,
    lost: reason => {
      if (reason) void replace(reason);
      else told.again();
    },
  };

  async function open(ways: BackendName[]): Promise<Backend> {
    for (const name of ways) {
      if (name === "svg") break;
      try {
        return await openGpu(name, stage, hooks);
      } catch (reason) {
        refused.push({ backend: name, reason: reason instanceof Error ? reason.message : String(reason) });
      }
    }
    return openSvg(stage, hooks);
  }

  let backend = await open(WAYS);
  async function replace(reason: unknown): Promise<void> {
    if (replacing || ended || backend.name === "svg") return;
    replacing = true;
    const gone = backend;
    refused.push({ backend: gone.name, reason: String(reason) });
    const next = await open(WAYS.slice(WAYS.indexOf(gone.name) + 1));
    remove(gone);
    backend = next;
    replacing = false;
    if (ended) backend.destroy();
    else told.replaced();
  }

  return {
    get backend() {
      return backend;
    },
    refused,
    replace,
    end() {
      ended = true;
      backend.destroy();
    },
  };
}

/** A lost device may refuse this too. */
function remove(gone: Backend): void {
  try {
    gone.destroy();
  } catch {
    gone.element.remove();
  }
}
