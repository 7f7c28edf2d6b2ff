import init, { version } from "@pkg/core/core.js";

await init();
const line = document.querySelector("#version");
if (line) line.textContent = version();
