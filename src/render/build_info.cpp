// SPDX-License-Identifier: Apache-2.0
#include <rakelight/context.h>
#include <rakelight/version.h>

#include "io/reader.h"
#include "render/engines.h"

namespace rakelight {
namespace {

/// The instruction sets of cmake/RakelightModule.cmake (RL_ISAS) that this processor has.
std::vector<std::string> usable_isas() {
    __builtin_cpu_init();
    std::vector<std::string> names{"scalar"};
    if (__builtin_cpu_supports("sse2")) names.push_back("sse2");
    if (__builtin_cpu_supports("avx2")) names.push_back("avx2");
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd"))
        names.push_back("avx512");
    return names;
}

}  // namespace

BuildInfo build_info() {
    BuildInfo info;
    info.version = RAKELIGHT_VERSION;
    info.engines = engine_names();
    info.model_formats = io::supported_formats();
    info.image_formats_read = "PNG, JPEG, WebP, EXR, HDR, TGA, BMP";  // what io/image_io.h promises
    info.image_formats_written = "PNG, JPEG, WebP, EXR, HDR";
    info.isas = usable_isas();
    info.isa = engine_isa(info.engines.front());
    info.threads = Context().threads();
    return info;
}

}  // namespace rakelight
