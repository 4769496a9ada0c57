/** The page: one state, one model that computes, views that draw and ask for changes. */

import wasm from "../../crates/archerfish-wasm/js/archerfish.wasm?url";
import { loadKernels, unsupported } from "./model/kernels.ts";
import { Model, type Scene } from "./model/model.ts";
import { type State, Store } from "./model/state.ts";
import { fromHash, toHash } from "./model/url.ts";
import { Explorer } from "./view/explorer.ts";
import { byId, make } from "./view/dom.ts";

export type { Scene, State };

async function bytes(address: string): Promise<BufferSource> {
  // In the page that is one file the module stands in the address itself, which needs no request.
  const inline = /^data:[^,]*;base64,(.*)$/.exec(address);
  if (inline) return Uint8Array.from(atob(inline[1] ?? ""), (character) => character.charCodeAt(0));
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status} ${answer.statusText}`);
  return answer.arrayBuffer();
}

async function start(): Promise<void> {
  const reason = unsupported();
  if (reason) return refuse(reason);
  try {
    const model = new Model(await loadKernels(await bytes(wasm)));
    const { state, messages } = fromHash(location.hash);
    const store = new Store(state);
    const explorer = new Explorer(store, model);
    // For the tests, and tools/bench.mjs.
    Object.assign(window, { archerfish: explorer.timings });
    explorer.complain(messages.length ? `${messages.join(". ")}. The rest of the view stands.` : undefined);
    window.addEventListener("hashchange", () => {
      if (location.hash.slice(1) === toHash(store.state)) return;
      const read = fromHash(location.hash);
      store.change(read.state);
      explorer.complain(read.messages.length ? `${read.messages.join(". ")}. The rest of the view stands.` : undefined);
    });
  } catch (error) {
    refuse(`The kernels could not be loaded: ${error instanceof Error ? error.message : error}`);
  }
}

/** Says in one sentence why there is no explorer. */
function refuse(sentence: string): void {
  document.querySelector("main")?.replaceChildren(make("p", { class: "refused", role: "alert" }, sentence));
  byId("message").hidden = true;
}

void start();
