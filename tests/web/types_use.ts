// SPDX-License-Identifier: Apache-2.0
// Use of the package as its types allow it: compiled, not run.
import { Document, type Transform } from '@gltf-transform/core';
import { Group, Mesh, Object3D, Scene } from 'three';

import { RakelightError, compare, configure, explain, inspect, render, smooth, type Border, type InspectOptions } from 'rakelight';
import { loadAttributes } from 'rakelight/attributes';
import * as single from 'rakelight/attributes/single';
import { AttributesError, configure as configureScene, smoothSeams, type SmoothSeamsOptions, type SmoothSeamsReport } from 'rakelight/scene';

declare const model: Uint8Array, document: Document, group: Group, mesh: Mesh, scene: Scene, object: Object3D;

export async function documents(): Promise<void> {
    const options: SmoothSeamsOptions = { normals: 'seams', crease: 40, weight: 'fit', weldDistance: 1e-4, borderDistance: 0.01, tangents: 'always',
        bitangents: true, keepInstances: true, onReport: ({ seams, borders }) => console.log(seams?.turned, borders.largestDegrees) };
    const transform: Transform = smoothSeams(options);
    await document.transform(smoothSeams(), smoothSeams({ crease: 'auto' }), transform);
    await smoothSeams(options)(document);
}

export async function objects(): Promise<SmoothSeamsReport> {
    configureScene({ locateFile: name => `/assets/${name}` });
    for (const each of [group, mesh, scene, object]) await smoothSeams(each, { normals: 'model' });
    try {
        const report = await smoothSeams(group);
        const degrees: number | undefined = report.seams?.largestDegrees, kinds: string[] = report.remarks.map(({ kind }) => kind);
        console.log(degrees, kinds, report.changed, report.made);
        return report;
    } catch (fault) {
        if (fault instanceof AttributesError) console.error(fault.message);
        throw fault;
    }
}

/** A gate as its users write it. */
export async function gate(options: InspectOptions = { check: true, maxSeam: 2 }): Promise<Border[]> {
    configure({ wasmBinary: model });
    try {
        const { passed, schema, rows } = await inspect({ name: 'a.obj', bytes: model.buffer as ArrayBuffer, files: { 'a.mtl': model } }, options);
        const [row] = rows, worst: number = row.seams.seam_deg, failures: string[] = row.check?.failures.map(({ message }) => message) ?? [];
        console.log(passed, schema, worst, failures, row.objects[row.borders[0]?.object_a ?? 0]?.name, row.remarks_left_out);
        return row.borders;
    } catch (fault) {
        if (fault instanceof RakelightError && fault.exitCode === 4 && fault.code === 'bad_file') console.error(fault.file, fault.place, fault.advice);
        throw fault;
    }
}

export async function files(): Promise<Blob> {
    const fixed = await smooth(model, { format: 'glb', normals: 'seams', creaseAngle: 30, allowOutside: false });
    const names: string[] = Object.keys(fixed.files), turned: number | undefined = fixed.report.rows[0].seams?.turned;
    const picture = await render(fixed.bytes, { format: 'jpg', resolution: [640, 480], background: '#ffffff', view: 'front', samples: 4 });
    const { passed, rows: [{ flip, psnr_db }] } = await compare(picture.bytes, model, { maxFlip: 0.05, resolution: '640x480' });
    const { rows: [{ codes }] } = await explain(model, { pixel: [3, 4], resolution: [8, 8] });
    await explain(model, { pixel: '3,4' });
    console.log(names, turned, passed, flip, psnr_db?.toFixed(1), codes[2]);
    return new Blob([fixed.bytes, picture.bytes]);
}

export async function arrays(): Promise<Float32Array[]> {
    const attributes = await loadAttributes({ locateFile: name => name }), same: typeof attributes = await single.loadAttributes();
    const [made] = same.computeAttributes([{ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0] }], { scope: 'object' });
    return made ? [made.normals] : [];
}
