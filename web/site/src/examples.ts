// SPDX-License-Identifier: Apache-2.0
// Models to choose from; their files lie in examples/, beside the page.
import type { Model } from './protocol.js';

interface Example {
    name: string;
    title: string;
    about: string;
    /** The model's file, or a built-in shape. */
    model: string;
    /** All files, by their paths below examples/. */
    files: string[];
}

export const examples: readonly Example[] = [
    { name: 'spot', title: 'Spot', about: 'a cow in five slabs', model: 'spot_slab5.glb', files: ['spot_slab5.glb'] },
    { name: 'knight', title: 'Knight', about: '15 parts without normals', model: 'Knight_noNormals.glb', files: ['Knight_noNormals.glb'] },
    { name: 'head', title: 'Head', about: 'by Lee Perry-Smith, CC BY 3.0', model: 'head.obj', files: ['head.obj', 'head.mtl', 'color.jpg', 'normal_from_bump.png'] },
    { name: 'teapot', title: 'Teapot', about: 'of 1975, in patches', model: 'builtin:teapot', files: [] },
    { name: 'wall', title: 'Brick wall', about: 'for bumps and parallax', model: 'wall.obj', files: ['wall.obj', 'wall.mtl', 'brick_height.png', 'brick_normal.png'] },
];

export async function filesOfExample(name: string, signal: AbortSignal): Promise<Model> {
    const example = examples.find(other => other.name === name)!;
    const files = await Promise.all(example.files.map(async path => {
        const response = await fetch(`examples/${example.name}/${path}`, { signal }).catch(fault => {
            throw navigator.onLine ? fault : new Error(`${example.title} was not looked at before, so it is not there without a network`);
        });
        if (!response.ok) throw new Error(`${path}: ${response.status} ${response.statusText}`);
        return { path, bytes: await response.blob() };
    }));
    return { name: example.model, files };
}
