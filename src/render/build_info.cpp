// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/context.h>
#include <rakelight/version.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <sstream>

#include "io/reader.h"
#include "math/isa.h"
#include "render/engines.h"

namespace rakelight {
namespace {

std::vector<std::string> usable_isas() {
    std::vector<std::string> names;
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512})
        if (is_available(isa)) names.push_back(name(isa));
    return names;
}

/// The words of RL_LEFT_OUT (CMakeLists.txt).
std::vector<std::string> left_out_parts() {
    std::istringstream words(RL_LEFT_OUT);
    return {std::istream_iterator<std::string>(words), {}};
}

/// "PNG, JPEG", without the formats of parts that are left out.
std::string list_of_formats(const BuildInfo& info, std::initializer_list<std::string> names) {
    std::string list;
    for (const std::string& name : names) {
        const std::string part = name == "WebP" ? "webp" : name == "EXR" ? "exr" : "";
        if (std::ranges::find(info.left_out, part) == info.left_out.end()) list += (list.empty() ? "" : ", ") + name;
    }
    return list;
}

}  // namespace

BuildInfo build_info() {
    BuildInfo info;
    info.version = RAKELIGHT_VERSION;
    info.engines = engine_names();
    info.model_formats = io::supported_formats();
    info.left_out = left_out_parts();
    info.image_formats_read =  // what io/image_io.h promises
        list_of_formats(info, {"PNG", "JPEG", "WebP", "EXR", "HDR", "TGA", "BMP"});
    info.image_formats_written = list_of_formats(info, {"PNG", "JPEG", "WebP", "PPM", "EXR", "HDR"});
    info.isas = usable_isas();
    info.isa = engine_isa(info.engines.front());
    info.threads = Context().threads();
    return info;
}

}  // namespace rakelight
