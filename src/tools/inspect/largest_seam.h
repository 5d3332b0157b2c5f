// SPDX-License-Identifier: Apache-2.0
// The largest seam of an inspection: at a position that meshes share, or along borders that match.
#pragma once
#include <optional>
#include <string>

#include <rakelight/tools/inspect.h>

namespace rakelight {

struct LargestSeam {
    double deg = 0;
    std::uint32_t object_a = 0, object_b = 0;                    ///< into Inspection::objects
    dvec3 position{};                                            ///< [m] world
    bool is_along_borders = false;                               ///< of Inspection::matched
    std::uint32_t material_a = no_index, material_b = no_index;  ///< into Scene::materials; of Inspection::borders
};

/// Nothing where none is larger.
std::optional<LargestSeam> largest_seam(const Inspection& inspection, double than_deg = continuous_deg);

/// "between 'left' and 'right'", "between two meshes of 'car'"
std::string between_text(const Inspection& inspection, std::uint32_t object_a, std::uint32_t object_b);
/// The same, or "between 'red' and 'glass' of 'car'": the materials of two meshes of one object.
std::string between_text(const Inspection& inspection, const LargestSeam& seam);

}  // namespace rakelight
