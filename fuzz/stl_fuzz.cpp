// SPDX-License-Identifier: Apache-2.0
// STL, any bytes: they load or throw Error, and what loads is a valid scene.
#include <rakelight/scene/validate.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/stl/read_stl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rakelight;
    Context context({.threads = 1, .max_memory = 64u << 20});
    try {
        validate(io::stl::read_stl_bytes({reinterpret_cast<const char*>(data), size}, "fuzz.stl", context));
    } catch (const Error&) {
    }
    return 0;
}
