// SPDX-License-Identifier: Apache-2.0
// Compressed forms of cases of make_pose_cases.py: node pack_pose_cases.mjs [FOLDER]
// npm install @gltf-transform/core @gltf-transform/extensions draco3dgltf meshoptimizer
import { readFileSync, writeFileSync } from 'node:fs';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import draco3d from 'draco3dgltf';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';

const folder = (process.argv[2] ?? import.meta.dirname ?? '.') + '/';
await MeshoptEncoder.ready;
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
    'draco3d.encoder': await draco3d.createEncoderModule(), 'draco3d.decoder': await draco3d.createDecoderModule(),
    'meshopt.encoder': MeshoptEncoder, 'meshopt.decoder': MeshoptDecoder });

async function pack(from, to, about, extension, options) {
    const document = await io.readJSON({ json: JSON.parse(readFileSync(folder + from + '.gltf')), resources: {} });
    document.createExtension(extension).setRequired(true).setEncoderOptions(options);
    document.getRoot().getAsset().extras = { about };
    const { json, resources } = await io.writeJSON(document, { basename: to });
    for (const buffer of json.buffers)
        if (buffer.uri) buffer.uri = 'data:application/octet-stream;base64,' + Buffer.from(resources[buffer.uri]).toString('base64');
    writeFileSync(folder + to + '.gltf', JSON.stringify(json) + '\n');
}

const { EDGEBREAKER, SEQUENTIAL } = KHRDracoMeshCompression.EncoderMethod ?? { EDGEBREAKER: 1, SEQUENTIAL: 0 };
await pack('skin', 'skin_draco', 'skin.gltf by Draco, which puts the vertices in another order', KHRDracoMeshCompression, { method: EDGEBREAKER });
await pack('skin_morph', 'skin_morph_draco', 'skin_morph.gltf by Draco in the order of the file', KHRDracoMeshCompression, { method: SEQUENTIAL });
await pack('skin_morph', 'skin_morph_meshopt', 'skin_morph.gltf by meshopt, keys too', EXTMeshoptCompression, { method: 'quantize' });
await pack('skin', 'skin_meshopt_filter', 'skin.gltf by meshopt with filters', EXTMeshoptCompression, { method: 'filter' });
