// SPDX-License-Identifier: Apache-2.0
// MTL text, any bytes: all materials load into a valid scene.
#include <rakelight/scene/validate.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/obj/read_obj.h"
#include "support/temporary_folder.h"

namespace {

/// A folder of this process with the one texture name that inputs may use.
struct TextureFolder : rakelight::test::TemporaryFolder {
    TextureFolder() { write("t.png", "not decoded on loading"); }
};

const TextureFolder& folder() {
    static const TextureFolder made;
    return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    folder().write("a.mtl", std::string(reinterpret_cast<const char*>(data), size));
    rakelight::Context context({.threads = 1, .max_memory = 64u << 20});
    constexpr std::string_view text = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    try {
        validate(rakelight::io::obj::read_obj_text(text, folder().file("fuzz.obj"), {}, context));
    } catch (const rakelight::Error& e) {
        if (e.reason().find("more than the limit") == std::string::npos) std::abort();  // MTL text is never an error
    }
    return 0;
}
