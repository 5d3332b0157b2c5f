// SPDX-License-Identifier: Apache-2.0
// Replacement in builds without the engine trace.
#include <rakelight/radiosity/radiosity.h>

namespace rakelight {

Scene with_radiosity(Scene, const RadiositySettings&, RadiosityReport&, Context&, LitColors) {
    throw Error(ErrorCode::failed, "radiosity needs rays, and this build has no engine trace", {},
                "build it with -DRAKELIGHT_TRACE=ON")
        .about("method");
}

}  // namespace rakelight
