// Runs the Khronos glTF validator over files; errors and warnings fail. usage: node validate.mjs file.glb...
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const { validateBytes } = createRequire(import.meta.url)('gltf-validator');
const SEVERITY = ['error', 'warning', 'information', 'hint'];
let failed = process.argv.length < 3;
if (failed) console.error('usage: node validate.mjs file.glb...');
for (const file of process.argv.slice(2)) {
  const report = await validateBytes(new Uint8Array(readFileSync(file)), { uri: file, maxIssues: 200 });
  const { numErrors, numWarnings, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.animationCount} animations, ${report.info.totalVertexCount} vertices`);
  for (const issue of messages.filter((one) => one.severity < 2)) {
    console.log(`  ${SEVERITY[issue.severity]} ${issue.code} at ${issue.pointer || issue.offset}: ${issue.message}`);
  }
  failed ||= numErrors + numWarnings > 0;
}
process.exit(failed ? 1 : 0);
