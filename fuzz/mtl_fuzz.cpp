// SPDX-License-Identifier: Apache-2.0
// MTL text, any bytes: all materials load into a valid scene.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "io/obj/read_obj.h"
#include "scene/scene_tools.h"

namespace {

/// A folder of this process with the one texture name that inputs may use.
const std::filesystem::path& folder() {
    static const std::filesystem::path path = [] {
        const auto p = std::filesystem::temp_directory_path() / ("rakelight_mtl_fuzz_" + std::to_string(::getpid()));
        std::filesystem::create_directories(p);
        std::ofstream(p / "t.png") << "not decoded on loading";
        return p;
    }();
    return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::ofstream(folder() / "a.mtl", std::ios::binary)
        .write(reinterpret_cast<const char*>(data), std::streamsize(size));
    rakelight::Context context({.threads = 1, .max_memory = 64u << 20});
    constexpr std::string_view text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    try {
        validate(rakelight::io::obj::read_obj_text(text, (folder() / "fuzz.obj").string(), {}, context));
    } catch (const rakelight::Error& e) {
        if (e.reason().find("more than the limit") == std::string::npos) std::abort();  // MTL text is never an error
    }
    return 0;
}
