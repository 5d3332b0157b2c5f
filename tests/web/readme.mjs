// SPDX-License-Identifier: Apache-2.0
// The code blocks of the package's README, and the models and names that they use.
import { readFileSync } from 'node:fs';

import { Document, NodeIO } from '@gltf-transform/core';
import { render } from 'rakelight';
import { loadAttributes } from 'rakelight/attributes';

const text = readFileSync(new URL('./node_modules/rakelight/README.md', import.meta.url), 'utf8');

/** The texts of the fenced blocks of a language, in their order. */
export const blocksOf = language => [...text.matchAll(/^```(\w+)\n(.*?)^```/gms)].filter(([, word]) => word === language).map(([, , body]) => body);

/** What the blocks use without saying where it is from. */
export const declarations = `declare const obj: Uint8Array, mtl: Uint8Array, png: Uint8Array;
declare const bodyPositions: Float32Array, bodyIndices: Uint32Array, bodyMatrix: number[];
declare const wheelPositions: Float32Array, wheelIndices: Uint32Array, wheelMatrix: number[];
declare module 'draco3dgltf';  // a package without types
`;

/** Half a ball, from one longitude to the one across, seen from outside. */
export function half(start, columns = 8, rows = 6) {
    const positions = [], indices = [], width = columns + 1;
    for (let row = 0; row <= rows; ++row)
        for (let column = 0; column <= columns; ++column) {
            const a = start + Math.PI * column / columns, b = Math.PI * (0.1 + 0.8 * row / rows);
            positions.push(Math.sin(b) * Math.cos(a), Math.cos(b), -Math.sin(b) * Math.sin(a));
            if (row < rows && column < columns)
                for (const step of [0, width, width + 1, 0, width + 1, 1]) indices.push(row * width + column + step);
        }
    return { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
}

const halves = [half(0), half(Math.PI)];

/** A GLB of two halves, each smooth by itself: there is a seam between them. */
export async function robot() {
    const document = new Document(), buffer = document.createBuffer(), scene = document.createScene();
    const made = (await loadAttributes()).computeAttributes(halves, { scope: 'object', crease: 180 });
    halves.forEach(({ positions, indices }, i) => {
        const accessor = (array, type) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
        const primitive = document.createPrimitive().setIndices(accessor(indices, 'SCALAR'))
            .setAttribute('POSITION', accessor(positions, 'VEC3')).setAttribute('NORMAL', accessor(made[i].normals, 'VEC3'));
        scene.addChild(document.createNode(`half${i}`).setMesh(document.createMesh().addPrimitive(primitive)));
    });
    return new NodeIO().writeBinary(document);
}

/** The values of the declared names. */
export async function values() {
    const encode = words => new TextEncoder().encode(words), matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    const obj = encode('mtllib chair.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n');
    const mtl = encode('newmtl wood\nmap_Kd wood.png\n'), png = (await render(await robot(), { resolution: [32, 32] })).bytes;
    const [body, wheel] = halves;
    return { obj, mtl, png, bodyPositions: body.positions, bodyIndices: body.indices, bodyMatrix: matrix,
             wheelPositions: wheel.positions, wheelIndices: wheel.indices, wheelMatrix: matrix };
}
