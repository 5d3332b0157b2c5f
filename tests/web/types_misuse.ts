// SPDX-License-Identifier: Apache-2.0
// Each marked line must not compile.
import { Document } from '@gltf-transform/core';
import { Mesh } from 'three';

import { compare, explain, inspect, render, smooth } from 'rakelight';
import { loadAttributes } from 'rakelight/attributes';
import * as single from 'rakelight/attributes/single';
import { configure, smoothSeams } from 'rakelight/scene';

declare const model: Uint8Array, document: Document, mesh: Mesh;

// @ts-expect-error a word that is not there
smoothSeams({ normals: 'all' });
// @ts-expect-error a word of another option
smoothSeams({ weight: 'auto', tangents: 'mikktspace' });
// @ts-expect-error a misspelled option
smoothSeams({ weldDistances: 1 });
// @ts-expect-error a number as text
smoothSeams({ crease: '40' });
// @ts-expect-error the same of an object
smoothSeams(mesh, { normals: 'flat' });
// @ts-expect-error a document is not an object of three.js, nor options
smoothSeams(document);
// @ts-expect-error a transform takes a document
smoothSeams()(mesh);
// @ts-expect-error a geometry is not an object
smoothSeams(mesh.geometry, {});
// @ts-expect-error the report of an object comes later
smoothSeams(mesh).changed;
// @ts-expect-error a transform has no report
smoothSeams()(document).then(report => report.changed);
// @ts-expect-error a misspelled name
configure({ locate: () => '' });

// @ts-expect-error a misspelled option
inspect(model, { maxSeams: 2 });
// @ts-expect-error as the command line has it
inspect(model, { 'max-seam': 2 });
// @ts-expect-error a switch is no number
inspect(model, { check: 1 });
// @ts-expect-error what the package sets itself
inspect(model, { json: true });
// @ts-expect-error what would be written beside the model and lost
inspect(model, { heatmap: 'a.png' });
// @ts-expect-error a path is not its content
inspect('robot.glb');
// @ts-expect-error a file without its bytes
inspect({ name: 'robot.glb' });
// @ts-expect-error an option of another command
smooth(model, { resolution: [640, 480] });
// @ts-expect-error a format that cannot be written
smooth(model, { format: 'fbx' });
// @ts-expect-error a word that is not there
smooth(model, { normals: 'file' });
// @ts-expect-error what the package sets itself
smooth(model, { output: 'a.glb' });
// @ts-expect-error more than one picture
render(model, { turntable: 12 });
// @ts-expect-error an engine that this build lacks
render(model, { engine: 'gl' });
// @ts-expect-error a picture format that this build lacks
render(model, { format: 'exr' });
// @ts-expect-error two inputs
compare(model, { maxFlip: 1 });
// @ts-expect-error no pixel
explain(model);
// @ts-expect-error three numbers
explain(model, { pixel: [1, 2, 3] });
// @ts-expect-error no such member
inspect(model).then(({ rows }) => rows[0].seams.seam_deg.length);

// @ts-expect-error it loads nothing
single.loadAttributes({ locateFile: (name: string) => name });
// @ts-expect-error a word that is not there
loadAttributes().then(attributes => attributes.computeAttributes([], { scope: 'all' }));
