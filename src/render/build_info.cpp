// SPDX-License-Identifier: Apache-2.0
#include <rakelight/context.h>
#include <rakelight/version.h>

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

}  // namespace

BuildInfo build_info() {
    BuildInfo info;
    info.version = RAKELIGHT_VERSION;
    info.engines = engine_names();
    info.model_formats = io::supported_formats();
    info.image_formats_read = "PNG, JPEG, WebP, EXR, HDR, TGA, BMP";  // what io/image_io.h promises
    info.image_formats_written = "PNG, JPEG, WebP, PPM, EXR, HDR";
    info.isas = usable_isas();
    info.isa = engine_isa(info.engines.front());
    info.threads = Context().threads();
    return info;
}

}  // namespace rakelight
