// What stands between editor and form: the panel with the page in a frame, and the edits that a changed text comes to.
const { randomBytes } = require("node:crypto");

/** The document of a panel: the page in a frame; it hands messages on, from the editor to the page and back. */
function panel(address) {
  const { origin } = new URL(address);
  const nonce = randomBytes(16).toString("base64");
  const policy = `default-src 'none'; frame-src ${origin}; script-src 'nonce-${nonce}'; style-src 'nonce-${nonce}'`;
  return `<!doctype html>
<html>
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<title>Probewright</title>
<style nonce="${nonce}">
html, body, iframe { margin: 0; padding: 0; border: 0; width: 100%; height: 100%; display: block }
</style>
</head>
<body>
<iframe src="${address}#framed" title="Probewright" allow="clipboard-read; clipboard-write"></iframe>
<script nonce="${nonce}">
const editor = acquireVsCodeApi();
const page = document.querySelector("iframe");
addEventListener("message", ({ source, origin, data }) => {
  if (source !== page.contentWindow) page.contentWindow.postMessage(data, ${JSON.stringify(origin)});
  else if (origin === ${JSON.stringify(origin)}) editor.postMessage(data);
});
</script>
</body>
</html>`;
}

/** The one piece in which two texts differ: its place in the first, and what stands there in the second. */
function difference(before, after) {
  const shorter = Math.min(before.length, after.length);
  let start = 0;
  while (start < shorter && before[start] === after[start]) start++;
  let end = 0;
  while (end < shorter - start && before[before.length - 1 - end] === after[after.length - 1 - end]) end++;
  return { start, end: before.length - end, text: after.slice(start, after.length - end) };
}

/** A text with the line ends of the editor's document. */
function withEnds(text, crlf) {
  const plain = text.replace(/\r\n?/g, "\n");
  return crlf ? plain.replaceAll("\n", "\r\n") : plain;
}

module.exports = { panel, difference, withEnds };
