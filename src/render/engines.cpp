// SPDX-License-Identifier: Apache-2.0
#include "render/engines.h"

#include <rakelight/render.h>

#include <algorithm>

#include "engines/raster/raster_engine.h"

namespace rakelight {

std::vector<std::string> engine_names() { return {"soft"}; }

std::string engine_isa(const std::string& name) { return name == "soft" ? raster::isa_name() : std::string(); }

void check_engine_name(const std::string& name) {
    const std::vector<std::string> names = engine_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    std::string list;
    for (const std::string& n : names) list += (list.empty() ? "" : ", ") + n;
    throw Error(ErrorCode::usage, "engine '" + one_line(name, 40) + "' is not built in", {}, "this build has: " + list);
}

std::unique_ptr<Engine> make_engine(const std::string& name) {
    check_engine_name(name);
    return raster::make_engine();
}

}  // namespace rakelight
