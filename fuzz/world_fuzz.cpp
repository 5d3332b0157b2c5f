// SPDX-License-Identifier: Apache-2.0
// World files, any bytes: what is read is in range, all else is an error with its place.
#include <rakelight/base/error.h>
#include <rakelight/io/world.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const rakelight::WorldFile world = rakelight::parse_world({reinterpret_cast<const char*>(data), size});
        for (const rakelight::Camera& camera : world.cameras)
            if (!(camera.z_far > camera.z_near) || !std::isfinite(camera.to_world[3].x)) std::abort();
        for (const rakelight::Light& light : world.lights)
            if (!std::isfinite(light.position.x) || !(light.diffuse.x >= 0)) std::abort();
        for (const rakelight::WorldModel& model : world.models)
            if (model.file.empty() || model.placement.scale.x == 0) std::abort();
    } catch (const rakelight::Error& error) {
        if (error.place().empty()) std::abort();
    }
    return 0;
}
