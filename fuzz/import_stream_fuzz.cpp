// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the stream that the import helper sends. A helper that was taken over by a hostile file can send anything; the
// program must answer with a valid scene or an Error. The head is always right, so that the fuzzer starts behind it.
#include <rakelight/scene/validate.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "io/import/scene_from_import.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rakelight;
    const io::import_stream::Head head{io::import_stream::magic, io::import_stream::version,
                                       std::uint32_t(io::import_stream::Kind::scene)};
    std::vector<std::byte> bytes(sizeof head + size);
    std::memcpy(bytes.data(), &head, sizeof head);
    if (size != 0) std::memcpy(bytes.data() + sizeof head, data, size);
    Context context({.threads = 1, .max_memory = 64u << 20});
    try {
        io::import_stream::MemorySource source(bytes);
        const Scene scene = io::scene_from_import(io::import_stream::read_import(source, context), "fuzz/model.fbx",
                                                  "fbx", {}, context);
        validate(scene);
    } catch (const Error&) {  // the only exception that may come out
    }
    return 0;
}
