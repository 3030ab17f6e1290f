// Prints what Khronos' validator, which tools/get_gltf_validator.sh installs, says about a file, as JSON.
// Usage: node validate_gltf.mjs PROJECT_FOLDER FILE

import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const [project, file] = process.argv.slice(2);
const validator = createRequire(`${project}/build/gltf_validator/`)('gltf-validator');
const report = await validator.validateBytes(new Uint8Array(await readFile(file)), { maxIssues: 20 });
console.log(JSON.stringify(report));
