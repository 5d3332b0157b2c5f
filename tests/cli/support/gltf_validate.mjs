// SPDX-License-Identifier: Apache-2.0
// Compares what the Khronos validator says about pairs of glTF files: node gltf_validate.mjs PAIRS.json
// PAIRS.json: [["before.glb", "after.glb"], ...]. Prints every kind of error that a second file has more often than its first;
// exit code 1 when there is one, 77 when the npm package gltf-validator is not found (NODE_PATH or node_modules up the tree).
import {createRequire} from 'node:module';
import fs from 'node:fs';
import path from 'node:path';

let validator;
try {
    validator = createRequire(path.join(process.cwd(), 'x.js'))('gltf-validator');
} catch {
    console.log('SKIPPED: the npm package gltf-validator is not installed');
    process.exit(77);
}

async function errors(file) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
        uri: path.basename(file),
        maxIssues: 0,
        externalResourceFunction: uri =>
            Promise.resolve(new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))))
    });
    const counts = new Map();
    for (const m of report.issues.messages)
        if (m.severity === 0) counts.set(m.code, (counts.get(m.code) ?? 0) + 1);
    return counts;
}

let bad = 0;
const pairs = JSON.parse(fs.readFileSync(process.argv[2]));
for (const [before, after] of pairs) {
    const old = before ? await errors(before) : new Map();
    for (const [code, count] of await errors(after))
        if (count > (old.get(code) ?? 0)) {
            console.log(`${after}: ${code} ${count} times, ${old.get(code) ?? 0} before`);
            ++bad;
        }
}
console.log(`${pairs.length} pairs, ${bad} new kinds of errors`);
process.exit(bad ? 1 : 0);
