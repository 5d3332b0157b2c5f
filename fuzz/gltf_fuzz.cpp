// SPDX-License-Identifier: Apache-2.0
// Fuzz target: glTF and GLB files of any bytes load as valid scenes or throw Error. Seeds: any .gltf and .glb files,
// best with the data inside (GLB, data URIs), since references find nothing here.
#include <rakelight/scene/validate.h>

#include <cstdint>
#include <cstring>

#include "io/gltf/read_gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rakelight;
    const auto* begin = reinterpret_cast<const std::byte*>(data);
    auto file = std::make_shared<const std::vector<std::byte>>(begin, begin + size);
    Context context({.threads = 1, .max_memory = 256u << 20});
    try {
        const Scene scene = io::gltf::read_gltf_bytes("no_such_folder/model.glb", std::move(file), {}, context);
        validate(scene);
    } catch (const Error&) {  // the only exception that may come out
    }
    return 0;
}
