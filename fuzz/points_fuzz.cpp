// SPDX-License-Identifier: Apache-2.0
// PLY and lists of points, any bytes: they load or throw Error, and what loads is a valid scene whose points can be made surface.
#include <rakelight/scene/validate.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "io/ply/read_off.h"
#include "io/ply/read_ply.h"
#include "io/read_xyz.h"
#include "prepare/splat_points.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace rakelight;
    const std::string_view bytes{reinterpret_cast<const char*>(data), size};
    const auto try_reading = [&](auto&& read) {
        Context context({.threads = 1, .max_memory = 64u << 20});
        try {
            Scene scene = read(context);
            validate(scene);
            validate(splat_points(std::move(scene), context));
        } catch (const Error&) {
        }
    };
    // A folder that does not exist: no texture is ever found.
    try_reading(
        [&](Context& context) { return io::ply::read_ply_bytes(bytes, "no_such_folder/fuzz.ply", {}, context); });
    try_reading([&](Context& context) { return io::ply::read_off_text(bytes, "no_such_folder/fuzz.off", context); });
    try_reading([&](Context& context) { return io::read_xyz_text(bytes, "no_such_folder/fuzz.xyz", context); });
    return 0;
}
