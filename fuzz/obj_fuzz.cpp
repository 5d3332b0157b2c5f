// SPDX-License-Identifier: Apache-2.0
// OBJ text, any bytes: loads or throws Error, and what loads is a valid scene. Lines tile the file.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/obj/obj_lines.h"
#include "io/obj/read_obj.h"
#include "scene/scene_tools.h"

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    check_lines(text);
    rakelight::Context context({.threads = 1, .max_memory = 64u << 20});
    try {
        // A folder that does not exist: no material file is ever found.
        validate(rakelight::io::obj::read_obj_text(text, "no_such_folder/fuzz.obj", {}, context));
    } catch (const rakelight::Error&) {
    }
    return 0;
}
