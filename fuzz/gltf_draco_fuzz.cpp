// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the Draco buffer of a glTF primitive, any bytes. Whole files spend their time in JSON; this one starts
// behind it.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "io/gltf/packed/draco.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rakelight;
    using namespace rakelight::io::gltf;
    Context context({.threads = 1, .max_memory = 256u << 20});
    const Value from(nullptr, "mesh 0, primitive 0");
    try {
        const std::unique_ptr<DracoMesh> mesh = decode_draco(std::as_bytes(std::span(data, size)), from, context);
        for (const std::uint32_t corner : mesh->indices())
            if (corner >= mesh->vertex_count()) std::abort();
        Elements description;
        description.components = 3;
        for (std::uint32_t id = 0; id < 4; ++id) {
            try {
                const Elements found = mesh->attribute(id, description, from, context);
                if (found.count != mesh->vertex_count()) std::abort();
                to_vec3(found);
            } catch (const Error&) {
            }
        }
    } catch (const Error&) {  // the only exception that may come out
    }
    return 0;
}
