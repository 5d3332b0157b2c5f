// SPDX-License-Identifier: Apache-2.0
// Models as several objects.
#include <algorithm>

#include <rakelight/base/error.h>

#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

CreaseModel copy_of(const CreaseModels& from, const std::string& name, const std::string& how) {
    const auto at = std::ranges::find(from, name, &CreaseModel::name);
    if (at == from.end()) throw Error(ErrorCode::failed, "no model is named " + name);
    CreaseModel model = *at;
    model.name += ", " + how;
    return model;
}

/// The sector of `count` equal ones around the z axis.
std::uint32_t sector_of(dvec3 p, std::uint32_t count) {
    const double turn = 0.5 + math::atan2(p.y, p.x) / (2 * pi);
    return std::min(std::uint32_t(turn * count), count - 1);
}

void add_cut_models(CreaseModels& to) {
    const auto add = [&](const char* name, const char* how,
                         const std::function<std::uint32_t(dvec3, Surface)>& object_of) {
        CreaseModel model = copy_of(to, name, how);
        cut_into_objects(model, object_of);
        to.push_back(std::move(model));
    };
    add("hex nut, 4 decimals", "three objects", [](dvec3 p, Surface) { return sector_of(p, 3); });
    add("cylinder of 24 sides", "halves", [](dvec3 p, Surface) { return sector_of(p, 2); });
    add("bottle", "rings", [](dvec3 p, Surface) { return p.z < 1 ? 0u : p.z < 2.3 ? 1u : 2u; });
    add("gear of 12 teeth", "an object for each side", [](dvec3, Surface surface) { return surface % 7; });
    add("cylinder with a dome, 16 x 4", "quarters", [](dvec3 p, Surface) { return sector_of(p, 4); });
    add("chamfered box, 15 %", "halves", [](dvec3 p, Surface) { return p.x + p.y > 0.01 ? 1u : 0u; });
    add("torus of 12 x 8", "six objects", [](dvec3 p, Surface) { return sector_of(p, 6); });
}

}  // namespace

constinit const ModelFamily cut_models{.add = add_cut_models};

}  // namespace rakelight
