// Khronos's glTF validator over files: node validate.mjs MODULES FILE...
// Prints a JSON object a file: {"file", "messages": [{"code", "message", "severity", "pointer"}]}.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';

const [modules, ...files] = process.argv.slice(2);
const {validateBytes} = createRequire(join(modules, 'x.js'))('gltf-validator');
for (const file of files) {
  const report = await validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    maxIssues: 100,
    externalResourceFunction: uri =>
        Promise.resolve(new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri))))),
  });
  const {messages, truncated} = report.issues;
  console.log(JSON.stringify({file, messages, truncated, info: report.info}));
}
