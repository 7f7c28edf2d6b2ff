// The extension for Visual Studio Code without that editor: what it serves, what it starts, what it does with a form;
// and the page in the frame of a form.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer, request } from "node:http";
import { createRequire, Module } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { address, launch } from "./browser.mjs";

const folder = fileURLToPath(new URL("../../editors/vscode/", import.meta.url));
const own = createRequire(join(folder, "package.json"));
const { panel, difference, withEnds } = own("./relay.js");

// The status of an answer, and its text.
function ask(port, path, { method = "GET", host } = {}) {
  return new Promise((resolve, reject) => {
    const asked = request({ port, path, method, host: "127.0.0.1", headers: host ? { host } : {} }, answer => {
      let text = "";
      answer.setEncoding("utf8").on("data", piece => {
        text += piece;
      });
      answer.on("end", () => resolve({ status: answer.statusCode, text, type: answer.headers["content-type"] }));
    });
    asked.on("error", reject).end();
  });
}

describe("what the extension serves", () => {
  let served;
  let root;

  before(async () => {
    root = mkdtempSync(join(tmpdir(), "probewright-"));
    writeFileSync(join(root, "index.html"), "<p>");
    writeFileSync(join(root, "sw.js"), "");
    writeFileSync(`${root}-secret`, "no");
    served = await own("./pages.js").serve(root);
  });
  after(() => {
    served.close();
    for (const path of [root, `${root}-secret`]) rmSync(path, { recursive: true, force: true });
  });

  // oracle: hand
  test("is the page, for who knows the address, from this machine", async () => {
    const { port, path } = served;
    assert.deepEqual(await ask(port, path), { status: 200, text: "<p>", type: "text/html; charset=utf-8" });
    for (const [wrong, options] of [
      ["/"],
      ["/index.html"],
      [`${path}sw.js`],
      [`${path}none.js`],
      [`${path}..%2f${root.split("/").at(-1)}-secret`],
      [`${path}%00`],
      [`${path}%zz`],
      [path, { method: "POST" }],
      [path, { host: "elsewhere.example" }],
    ])
      assert.equal((await ask(port, wrong, options)).status, 404, `${wrong} ${JSON.stringify(options)}`);
  });
});

// An editor that remembers what the extension does with it.
function fakeEditor(text) {
  const done = { commands: {}, edits: [], sent: [], clients: [], errors: [] };
  const opened = text => {
    const document = {
      text,
      fileName: "/parts/a.mpf",
      languageId: "sinumerik",
      eol: 2,
      uri: { toString: () => "file:///parts/a.mpf" },
      getText: () => document.text,
      positionAt: offset => offset,
    };
    return document;
  };
  const document = opened(text);
  let now = document;
  const window = {
    activeTextEditor: { document, selection: { active: { line: 1 } } },
    createWebviewPanel: () => shown,
    showErrorMessage: message => {
      done.errors.push(message);
      return new Promise(() => {}); // it stays open
    },
  };
  /** Closes the document; the one that is opened in its place. */
  const reopen = text => {
    now = opened(text);
    window.activeTextEditor.document = now;
    return now;
  };
  class LanguageClient {
    constructor(...all) {
      this.all = all;
      done.clients.push(this);
    }
    start = async () => {};
    stop = async () => {};
    sendNotification = (...all) => done.sent.push(all);
  }
  class WorkspaceEdit {
    replace = (_uri, range, insert) => Object.assign(this, { range, insert });
  }
  const webview = {
    onDidReceiveMessage: hear => {
      done.hear = hear;
    },
    postMessage: message => {
      done.sent.push(message);
      return new Promise(() => {}); // a panel that is still loading
    },
  };
  const shown = { webview, onDidDispose: () => {}, reveal: () => {} };
  const vscode = {
    EndOfLine: { LF: 1, CRLF: 2 },
    ViewColumn: { Beside: -2 },
    Range: class {
      constructor(start, end) {
        Object.assign(this, { start, end });
      }
    },
    Uri: { parse: text => ({ toString: () => text }) },
    WorkspaceEdit,
    l10n: { t: (key, ...all) => [key, ...all].join(" ") },
    env: { asExternalUri: async uri => uri },
    commands: { registerCommand: (name, run) => Object.assign(done.commands, { [name]: run }) },
    window,
    workspace: {
      openTextDocument: async () => now,
      applyEdit: async edit => {
        done.edits.push(edit);
        await Promise.resolve();
        now.text = now.text.slice(0, edit.range.start) + edit.insert + now.text.slice(edit.range.end);
        done.changed?.({ document: now, contentChanges: [edit] });
      },
      getConfiguration: () => ({
        get: (_name, fallback) => fallback,
        setup: "mill.json",
        with: ["subs"],
        control: null,
      }),
      onDidChangeConfiguration: tell => Object.assign(done, { tell }),
      onDidChangeTextDocument: changed => {
        done.changed = changed;
        return { dispose: () => {} };
      },
    },
  };
  return {
    vscode,
    done,
    document,
    reopen,
    shown,
    modules: { vscode, "vscode-languageclient/node": { LanguageClient } },
  };
}

// The extension with these modules in the place of the editor's.
function extension(modules) {
  const before = Module._load;
  Module._load = (name, ...rest) => modules[name] ?? before(name, ...rest);
  try {
    const path = own.resolve("./extension.js");
    delete own.cache[path];
    return own(path);
  } finally {
    Module._load = before;
  }
}

/** The extension with a page in its folder, and its form for the document; `{ close }`. */
async function withForm({ done, modules }) {
  const root = mkdtempSync(join(tmpdir(), "probewright-"));
  const context = { subscriptions: [], extensionPath: root };
  const close = () => {
    for (const one of context.subscriptions) one?.dispose?.();
    rmSync(root, { recursive: true, force: true });
  };
  mkdirSync(join(root, "page"));
  writeFileSync(join(root, "page", "index.html"), "");
  await extension(modules).activate(context);
  await done.commands["probewright.form"]();
  return { close };
}

describe("the extension", () => {
  // oracle: hand
  test("starts the server with the settings, and tells it of others", async () => {
    const { done, modules } = fakeEditor("");
    await extension(modules).activate({ subscriptions: [], extensionPath: folder });
    const [, , run, options] = done.clients[0].all;
    assert.deepEqual(run, { command: "probewright", args: ["lsp"] });
    assert.deepEqual(options.initializationOptions, { setup: "mill.json", with: ["subs"], control: null });
    done.tell({ affectsConfiguration: () => true });
    const settings = { probewright: { setup: "mill.json", with: ["subs"], control: null } };
    assert.deepEqual(done.sent, [["workspace/didChangeConfiguration", { settings }]]);
  });

  // oracle: hand (line feeds for the form, the line ends of the document in it; one piece is replaced)
  test("opens a form, and writes back what it changes", async () => {
    const { done, document, modules, shown } = fakeEditor("_MVAR=1\r\nCYCLE977\r\n");
    const root = mkdtempSync(join(tmpdir(), "probewright-"));
    const context = { subscriptions: [], extensionPath: root };
    try {
      await extension(modules).activate(context);
      await done.commands["probewright.form"]();
      assert.deepEqual(done.errors, ["The page of Probewright is not part of this extension."]);
      mkdirSync(join(root, "page"));
      writeFileSync(join(root, "page", "index.html"), "");
      await done.commands["probewright.form"]();
      assert.match(shown.webview.html, /<iframe src="http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\/#framed"/);
      done.sent.length = 0;
      await done.hear({ probewright: "ready" });
      const text = "_MVAR=1\nCYCLE977\n";
      const given = { probewright: "open", control: "sinumerik", name: "a.mpf", text, line: 2 };
      assert.deepEqual(done.sent, [given]);
      await done.hear({ probewright: "program", text: "_MVAR=1 _SETVAL=20\nCYCLE977\n" });
      assert.equal(document.text, "_MVAR=1 _SETVAL=20\r\nCYCLE977\r\n");
      assert.equal(done.edits[0].insert, " _SETVAL=20");
      assert.equal(done.sent.length, 1, "the form has it already");
      document.text = "M30\r\n";
      done.changed({ document, contentChanges: [{}] });
      assert.equal(done.sent[1].text, "M30\n");
      await done.hear({ probewright: "program", text: 7 });
      await done.hear(null);
      assert.equal(done.edits.length, 1);
    } finally {
      for (const one of context.subscriptions) one?.dispose?.();
      rmSync(root, { recursive: true, force: true });
    }
  });

  // oracle: hand
  test("writes changes that come at once after each other", async () => {
    const editor = fakeEditor("_MVAR=1\r\nCYCLE977\r\n");
    const { done, document } = editor;
    const { close } = await withForm(editor);
    try {
      done.sent.length = 0;
      const typed = ["4", "41", "413"].map(value => `_MVAR=1 _SETVAL=${value}\nCYCLE977\n`);
      await Promise.all(typed.map(text => done.hear({ probewright: "program", text })));
      assert.equal(document.text, "_MVAR=1 _SETVAL=413\r\nCYCLE977\r\n");
      assert.deepEqual(
        done.edits.map(({ insert }) => insert),
        [" _SETVAL=4", "1", "3"],
      );
      assert.deepEqual(done.sent, [], "the form has them already");
    } finally {
      close();
    }
  });

  // oracle: hand
  test("goes on with the document that is opened after it was closed", async () => {
    const editor = fakeEditor("CYCLE977\r\n");
    const { done, document } = editor;
    const { close } = await withForm(editor);
    try {
      const other = editor.reopen("N10 G17\r\nCYCLE977\r\n");
      await done.commands["probewright.form"]();
      assert.equal(done.sent.at(-1).text, "N10 G17\nCYCLE977\n");
      await done.hear({ probewright: "program", text: "N10 G17\n_MVAR=1\nCYCLE977\n" });
      assert.equal(other.text, "N10 G17\r\n_MVAR=1\r\nCYCLE977\r\n");
      assert.equal(document.text, "CYCLE977\r\n");
      other.text = "M30\r\n";
      done.changed({ document: other, contentChanges: [{}] });
      assert.equal(done.sent.at(-1).text, "M30\n");
    } finally {
      close();
    }
  });

  // oracle: hand
  test("tells why a change cannot be written, and writes the next one", async () => {
    const editor = fakeEditor("CYCLE977\r\n");
    const { done, document, vscode } = editor;
    const { close } = await withForm(editor);
    const { openTextDocument } = vscode.workspace;
    try {
      vscode.workspace.openTextDocument = async () => {
        throw new Error("it is gone");
      };
      await done.hear({ probewright: "program", text: "M0\n" });
      assert.deepEqual(done.errors, ["it is gone"]);
      vscode.workspace.openTextDocument = openTextDocument;
      await done.hear({ probewright: "program", text: "M30\n" });
      assert.equal(document.text, "M30\r\n");
    } finally {
      close();
    }
  });

  // oracle: hand
  test("replaces the one piece that differs", () => {
    assert.deepEqual(difference("aXb", "aYb"), { start: 1, end: 2, text: "Y" });
    assert.deepEqual(difference("aa", "aaa"), { start: 2, end: 2, text: "a" });
    assert.deepEqual(difference("same", "same"), { start: 4, end: 4, text: "" });
    assert.equal(withEnds("a\r\nb\rc\n", true), "a\r\nb\r\nc\r\n");
  });
});

describe("the server, asked by the library of Visual Studio Code", () => {
  const program =
    process.env.PROBEWRIGHT_SERVER ?? fileURLToPath(new URL("../../target/debug/probewright", import.meta.url));

  // oracle: peer (vscode-languageserver-protocol, the makers' own messages)
  test("begins, tells findings, explains and ends", async () => {
    const { createProtocolConnection } = own("vscode-languageserver-protocol/node");
    const { StreamMessageReader, StreamMessageWriter } = own("vscode-languageserver-protocol/node");
    const server = spawn(program, ["lsp"]);
    const ended = new Promise(resolve => server.on("exit", resolve));
    const { stdout, stdin } = server;
    const client = createProtocolConnection(new StreamMessageReader(stdout), new StreamMessageWriter(stdin));
    const found = new Promise(resolve => client.onNotification("textDocument/publishDiagnostics", resolve));
    client.listen();
    const begun = await client.sendRequest("initialize", { processId: process.pid, rootUri: null, capabilities: {} });
    assert.equal(begun.capabilities.documentFormattingProvider, undefined);
    await client.sendNotification("initialized", {});
    const textDocument = {
      uri: "file:///parts/a.mpf",
      languageId: "sinumerik",
      version: 1,
      text: "_MVAR=1,5\nCYCLE977\n",
    };
    await client.sendNotification("textDocument/didOpen", { textDocument });
    const { diagnostics } = await found;
    assert.ok(diagnostics.some(one => one.code === "PW100" && one.range.start.line === 0));
    const position = { line: 1, character: 2 };
    const told = await client.sendRequest("textDocument/hover", { textDocument, position });
    assert.match(told.contents.value, /^CYCLE977/);
    await client.sendRequest("shutdown");
    await client.sendNotification("exit");
    assert.equal(await ended, 0);
    client.dispose();
  });
});

describe("the page in the frame of a form", () => {
  let browser;
  let server; // of the panel: another origin than that of the page
  let outer;

  before(async () => {
    const html = { "Content-Type": "text/html; charset=utf-8" };
    server = createServer((_, answer) => answer.writeHead(200, html).end(panel(address)));
    await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
    outer = `http://127.0.0.1:${server.address().port}/`;
    browser = await launch();
  });
  after(async () => {
    await browser.close();
    server.close();
  });

  // oracle: hand
  test("shows the call at the cursor, and tells what is changed in it", async () => {
    const context = await browser.newContext({ viewport: { width: 1000, height: 800 }, locale: "en-GB" });
    context.setDefaultTimeout(20_000);
    const page = await context.newPage();
    await page.addInitScript(() => {
      if (window !== parent) return;
      globalThis.heard = [];
      globalThis.acquireVsCodeApi = () => ({ postMessage: message => globalThis.heard.push(message) });
    });
    await page.goto(outer);
    const heard = () => page.evaluate(() => globalThis.heard);
    await page.waitForFunction(() => globalThis.heard.some(one => one.probewright === "ready"));
    const text = "N10 G17\n_MVAR=1 _SETVAL=132 _KNUM=0\nCYCLE977\n_MVAR=2 _SETVAL=40\nCYCLE977\nM30\n";
    const given = { probewright: "open", control: "sinumerik", name: "a.mpf", text, line: 5 };
    await page.evaluate(message => postMessage(message, "*"), given);
    const frame = page.frameLocator("iframe");
    const value = frame.locator('.field[data-field="_SETVAL"] .figure');
    await frame.locator('.cm-line:has-text("_SETVAL=40")').first().waitFor();
    await page.waitForFunction(() => true);
    assert.deepEqual((await heard()).slice(1), [], "nothing is changed by being shown");
    await value.fill("41");
    await page.waitForFunction(() => globalThis.heard.length > 1);
    const told = (await heard()).at(-1);
    assert.deepEqual(told, { probewright: "program", text: text.replace("_SETVAL=40", "_SETVAL=41") });
    await context.close();
  });
});
