// SPDX-License-Identifier: Apache-2.0
// An MTL file as written: its materials, values and texture lines, nothing interpreted yet.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

#include "io/obj/mtl_map.h"
#include "io/obj/obj_remarks.h"

namespace rakelight::io::obj {

/// One newmtl block. Colors are display values as written. Keys of `maps` are in lower case: "map_kd", "map_bump" (also
/// for bump), "norm", "disp", "map_pr", ...; the last line of a kind counts.
struct MtlMaterial {
    std::string name;
    std::uint64_t line = 0;
    std::optional<vec3> ambient, diffuse, specular, emission, filter;                  ///< Ka, Kd, Ks, Ke, Tf
    std::optional<double> exponent, dissolve, transparency, ior, roughness, metallic;  ///< Ns, d, Tr, Ni, Pr, Pm
    std::optional<double> anisotropy, anisotropy_rotation;  ///< aniso 0..1, anisor 0..1 turns
    std::optional<std::int64_t> illumination;               ///< illum
    std::map<std::string, MtlMap> maps;
    const MtlMap* map(const std::string& key) const {
        const auto found = maps.find(key);
        return found != maps.end() ? &found->second : nullptr;
    }
};

/// Reads all materials; lines that cannot be read go into the remarks.
/// @throws Error bad_file: over the memory limit; failed: cancelled
std::vector<MtlMaterial> read_mtl(std::string_view file, Remarks& remarks, Context& context);

}  // namespace rakelight::io::obj
