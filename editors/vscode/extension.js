// Probewright in Visual Studio Code: starts the language server, and shows the call at the cursor as a form.
const { existsSync } = require("node:fs");
const { basename, join } = require("node:path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");
const { serve } = require("./pages");
const { difference, panel, withEnds } = require("./relay");

const SETTING = "probewright";
const LANGUAGES = ["sinumerik", "nct"];

let client;

/** Starts the server with the settings of the editor; it is told when they change. */
async function start() {
  const run = { command: vscode.workspace.getConfiguration(SETTING).get("server", "probewright"), args: ["lsp"] };
  client = new LanguageClient(SETTING, "Probewright", run, {
    documentSelector: LANGUAGES.map(language => ({ language })),
    initializationOptions: machine(),
  });
  try {
    await client.start();
  } catch (problem) {
    vscode.window.showErrorMessage(
      vscode.l10n.t("The language server does not start: {0}", String(problem.message ?? problem)),
    );
  }
}

/** What the settings say about the machine, for the server. */
function machine() {
  const { setup, with: files, control } = vscode.workspace.getConfiguration(SETTING);
  return { setup, with: files ?? [], control };
}

/** The server is told of other settings. */
function tell(changed) {
  if (!changed.affectsConfiguration(SETTING)) return;
  client?.sendNotification("workspace/didChangeConfiguration", { settings: { [SETTING]: machine() } });
}

/** Forms by the address of their document, and the page that they show. */
function createForms(context) {
  const folder = join(context.extensionPath, "page");
  const open = new Map();
  let pages;
  context.subscriptions.push({ dispose: () => void pages?.then(({ close }) => close()) });

  const given = (document, line) => {
    const name = basename(document.fileName);
    const control = document.languageId === "nct" ? "nct" : "sinumerik";
    return { probewright: "open", control, name, text: withEnds(document.getText(), false), line };
  };

  async function take(uri, text) {
    const document = await vscode.workspace.openTextDocument(uri);
    const before = document.getText();
    const { start, end, text: insert } = difference(before, withEnds(text, document.eol === vscode.EndOfLine.CRLF));
    if (start === end && insert === "") return;
    const edit = new vscode.WorkspaceEdit();
    const range = new vscode.Range(document.positionAt(start), document.positionAt(end));
    edit.replace(uri, range, insert);
    await vscode.workspace.applyEdit(edit);
  }

  function create({ uri, fileName }, address) {
    const key = uri.toString();
    const title = vscode.l10n.t("Form: {0}", basename(fileName));
    const options = { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] };
    const shown = vscode.window.createWebviewPanel("probewright.form", title, vscode.ViewColumn.Beside, options);
    let line = 1;
    let told; // the text as the form has made it
    const send = document => shown.webview.postMessage(given(document, line));
    // by its address: once it is closed, the document is another when it is opened again
    const sendNow = async () => {
      send(await vscode.workspace.openTextDocument(uri));
    };
    let last = Promise.resolve();
    const inTurn = work => {
      last = last.then(work).catch(problem => {
        vscode.window.showErrorMessage(String(problem.message ?? problem)); // nothing waits until it is closed
      });
      return last;
    };
    shown.webview.onDidReceiveMessage(async message => {
      if (message?.probewright === "ready") await inTurn(sendNow);
      else if (message?.probewright === "program" && typeof message.text === "string")
        await inTurn(() => {
          told = message.text;
          return take(uri, message.text);
        });
    });
    const watch = vscode.workspace.onDidChangeTextDocument(({ document, contentChanges }) => {
      if (document.uri.toString() !== key || contentChanges.length === 0) return;
      if (withEnds(document.getText(), false) !== told) send(document); // else the form has it already
    });
    shown.onDidDispose(() => {
      watch.dispose();
      open.delete(key);
    });
    shown.webview.html = panel(address);
    return {
      show(at) {
        line = at;
        shown.reveal(undefined, true);
        return inTurn(sendNow);
      },
    };
  }

  return async () => {
    const editor = vscode.window.activeTextEditor;
    if (!editor) return;
    if (!existsSync(join(folder, "index.html"))) {
      vscode.window.showErrorMessage(vscode.l10n.t("The page of Probewright is not part of this extension."));
      return;
    }
    pages ??= serve(folder);
    const { port, path } = await pages;
    const local = vscode.Uri.parse(`http://127.0.0.1:${port}${path}`);
    const address = (await vscode.env.asExternalUri(local)).toString(true);
    const { document, selection } = editor;
    const key = document.uri.toString();
    const form = open.get(key) ?? create(document, address);
    open.set(key, form);
    await form.show(selection.active.line + 1);
  };
}

async function activate(context) {
  context.subscriptions.push(
    vscode.commands.registerCommand("probewright.form", createForms(context)),
    vscode.workspace.onDidChangeConfiguration(tell),
  );
  await start();
}

function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
