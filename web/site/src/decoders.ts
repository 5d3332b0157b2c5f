// SPDX-License-Identifier: Apache-2.0
// Decoders of compressed models, each loaded when a model needs it.
import type { Decoders } from './page_module.js';

export async function decoderFor(name: keyof Decoders): Promise<unknown> {
    if (name === 'meshopt') {
        const { MeshoptDecoder } = await import('meshoptimizer/decoder');
        await MeshoptDecoder.ready;
        return MeshoptDecoder;
    }
    const [{ default: createDecoder }, response] = await Promise.all([
        import('draco3dgltf/draco_decoder_gltf_nodejs.js'),
        fetch(new URL('draco_decoder_gltf.wasm', import.meta.url)),
    ]);
    return createDecoder({ wasmBinary: await response.arrayBuffer() });
}
