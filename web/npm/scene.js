// SPDX-License-Identifier: Apache-2.0
// Seams of whole documents: a transform of gltf-transform, and a function over objects of three.js. Which normals turn, which vertices
// split and which meshes need copies is found by the program's own code.
import { GltfDocument } from './gltf_document.js';
import { AttributesError } from './options.js';
import { SceneModule, configure } from './scene_module.js';
import { ThreeObject } from './three_object.js';

export { AttributesError, configure };

async function smooth(target, options) {
    const module = await SceneModule.begin();
    try {
        target.give(module);
        module.smooth(options);
        const report = module.report();
        report.remarks.push(...target.remarks ?? []);
        target.take(module, module.versions());
        options.onReport?.(report);
        return report;
    } finally {
        module.end();
    }
}

/** Of a document: smoothSeams(options) is the transform. Of three.js: smoothSeams(object, options) runs. */
export function smoothSeams(first, second) {
    if (first?.isObject3D) return smooth(new ThreeObject(first), second ?? {});
    const options = first ?? {};
    return async function smoothSeams(document) {
        const { remarks } = await smooth(new GltfDocument(document), options);
        for (const { kind, place, text } of remarks)
            document.getLogger()[kind === 'note' ? 'debug' : 'warn'](`smoothSeams: ${place ? place + ': ' : ''}${text}`);
    };
}
