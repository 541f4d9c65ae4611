// Starts `mansard lsp` and connects it to the editor.
"use strict";

const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

async function start() {
  const settings = vscode.workspace.getConfiguration("mansard");
  const args = ["lsp"];
  for (const folder of settings.get("stylePath", [])) args.push("--style-path", folder);
  const run = { command: settings.get("program", "mansard"), args };
  client = new LanguageClient(
    "mansard",
    "Mansard",
    { run, debug: run },
    {
      documentSelector: [{ language: "mansard" }],
      synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.style") },
    },
  );
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(
      `Mansard: '${run.command}' does not start: ${error.message}. Set mansard.program to the program's path.`,
    );
  }
}

async function stop() {
  if (client && client.isRunning()) await client.stop();
  client = undefined;
}

async function restart() {
  await stop();
  await start();
}

function activate(context) {
  context.subscriptions.push(
    vscode.commands.registerCommand("mansard.restart", restart),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("mansard")) restart();
    }),
  );
  return start();
}

module.exports = { activate, deactivate: stop };
