// SPDX-License-Identifier: Apache-2.0
// OBJ text, any bytes: loads or throws Error, and what loads is a valid scene, the same wherever the text is cut into chunks. Lines
// tile the file, and chunks hold whole ones.
#include <rakelight/scene/validate.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>

#include "io/obj/obj_lines.h"
#include "io/obj/read_obj.h"

namespace {

void check_lines(std::string_view text) {
    using namespace rakelight::io::obj;
    LineReader reader(text);
    std::size_t at = text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
    for (Line line; reader.next(line);) {
        if (line.begin != at || line.end < line.begin || line.next < line.end || line.next <= at) std::abort();
        Tokens words = reader.arguments(line);
        for (Token t; words.next(t);)
            if (t.text.empty() || t.begin < line.begin || t.end() > line.end ||
                text.substr(t.begin, t.text.size()) != t.text)
                std::abort();
        at = line.next;
    }
    if (at < text.size()) std::abort();
}

void check_chunks(std::string_view text, std::size_t bytes) {
    using namespace rakelight::io::obj;
    LineReader whole(text);
    Line expected;
    for (const Chunk& chunk : chunks_of(text, bytes)) {
        LineReader lines(text, chunk, 1);
        for (Line line; lines.next(line);)
            if (!whole.next(expected) || line.begin != expected.begin || line.next != expected.next) std::abort();
    }
    if (whole.next(expected)) std::abort();
}

/// @return no scene where it is refused
std::optional<rakelight::Scene> load(std::string_view text, std::size_t chunk_bytes) {
    rakelight::Context context({.threads = 1, .max_memory = 64u << 20});
    try {
        // A folder that does not exist: no material file is ever found.
        rakelight::Scene scene =
            rakelight::io::obj::read_obj_text(text, "no_such_folder/fuzz.obj", {}, context, chunk_bytes);
        validate(scene);
        return scene;
    } catch (const rakelight::Error&) {
        return {};
    }
}

bool are_alike(const rakelight::Scene& a, const rakelight::Scene& b) {
    const auto same = [](const auto& x, const auto& y) {
        return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0);
    };
    return a.nodes == b.nodes && std::equal(a.meshes.begin(), a.meshes.end(), b.meshes.begin(), b.meshes.end(),
                                            [&](const rakelight::Mesh& m, const rakelight::Mesh& n) {
                                                return same(m.positions, n.positions) && same(m.normals, n.normals) &&
                                                       same(m.indices, n.indices) && same(m.smoothing, n.smoothing) &&
                                                       same(m.polygons, n.polygons) && same(m.colors, n.colors);
                                            });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    check_lines(text);
    const std::size_t bytes = size == 0 ? 1 : 1 + data[size / 2] % 64;
    check_chunks(text, bytes);
    const auto whole = load(text, std::size_t(1) << 30), in_parts = load(text, bytes);
    if (whole && in_parts && !are_alike(*whole, *in_parts)) std::abort();
    return 0;
}
