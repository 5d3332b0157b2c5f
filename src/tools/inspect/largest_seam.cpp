// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/largest_seam.h"

#include "tools/object_name.h"

namespace rakelight {

std::optional<LargestSeam> largest_seam(const Inspection& i, double than_deg) {
    std::optional<LargestSeam> largest;
    if (!i.borders.empty() && i.seams.seam_deg > than_deg) {
        const BorderSummary& b = i.borders.front();
        largest = {i.seams.seam_deg, b.object_a, b.object_b, b.seam_position, false, b.material_a, b.material_b};
    }
    if (i.matched.pairs.empty() || !(i.matched.seam_deg > than_deg)) return largest;
    if (largest && largest->deg >= i.matched.seam_deg) return largest;
    const MatchedPair& p = i.matched.pairs.front();
    return LargestSeam{.deg = i.matched.seam_deg,
                       .object_a = p.object_a,
                       .object_b = p.object_b,
                       .position = p.seam_position,
                       .is_along_borders = true};
}

std::string between_text(const Inspection& i, std::uint32_t object_a, std::uint32_t object_b) {
    return object_a == object_b ? "between two meshes of " + quoted_name(i, object_a)
                                : "between " + quoted_name(i, object_a) + " and " + quoted_name(i, object_b);
}

std::string between_text(const Inspection& i, const LargestSeam& seam) {
    const std::uint32_t a = seam.material_a, b = seam.material_b;
    if (seam.object_a != seam.object_b || a == b || a == no_index || b == no_index)
        return between_text(i, seam.object_a, seam.object_b);
    const auto name = [&](std::uint32_t material) {
        const std::string& text = i.scene.materials[material].name;
        return text.empty() ? "material " + std::to_string(material) : "'" + one_line(text, max_name) + "'";
    };
    return "between " + name(a) + " and " + name(b) + " of " + quoted_name(i, seam.object_a);
}

}  // namespace rakelight
