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
    let isBroken = false;
    try {
        target.give(module);
        module.smooth(options);
        const report = module.report();
        target.take(module, module.versions());
        report.remarks.push(...target.remarks ?? []);
        options.onReport?.(report);
        return report;
    } catch (fault) {
        isBroken = fault instanceof WebAssembly.RuntimeError;
        throw fault;
    } finally {
        isBroken ? SceneModule.forget() : module.end();
    }
}

/** Rejects common wrong arguments. */
function checked(options) {
    if (options.scene?.isObject3D) throw new AttributesError('smoothSeams() takes an object of three.js: pass gltf.scene');
    if (options.isBufferGeometry) throw new AttributesError('smoothSeams() takes an object of three.js: pass the mesh of the geometry');
    if (typeof options.getRoot === 'function') throw new AttributesError('smoothSeams() makes a transform: await document.transform(smoothSeams())');
    if (typeof options !== 'object' || Array.isArray(options)) throw new AttributesError('smoothSeams() takes options, or an object of three.js');
    return options;
}

/** Of a document: smoothSeams(options) is the transform. Of three.js: smoothSeams(object, options) runs. */
export function smoothSeams(first, second) {
    if (first?.isObject3D) return smooth(new ThreeObject(first), second ?? {});
    const options = checked(first ?? {});
    return async function smoothSeams(document) {
        const { remarks } = await smooth(new GltfDocument(document), options);
        for (const { kind, place, text } of remarks)
            document.getLogger()[kind === 'note' ? 'debug' : 'warn'](`smoothSeams: ${place ? place + ': ' : ''}${text}`);
    };
}
