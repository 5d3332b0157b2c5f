// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/whole_inspection.h"

#include <algorithm>
#include <string>

namespace rakelight {
namespace {

void require(bool is_fine, const char* what) {
    if (!is_fine) throw Error(ErrorCode::usage, std::string("the inspection is inconsistent: ") + what);
}

}  // namespace

void check_whole(const Inspection& i) {
    const auto is_object = [&](std::uint32_t number) { return number < i.objects.size(); };
    require(i.material_objects.size() == i.scene.materials.size(), "the objects of its materials");
    require(i.surfaces.empty() || i.surfaces.size() == i.objects.size(), "as many surfaces as objects");
    bool has_t_junction = false;
    for (const SurfaceSummary& s : i.surfaces) has_t_junction = has_t_junction || s.t_junctions > 0;
    require(!has_t_junction || !i.t_junction_places.empty(), "places of T-junctions");
    require(i.t_junctions >= i.t_junction_places.size(), "places of T-junctions");
    for (const TJunctionPlace& t : i.t_junction_places)
        require(is_object(t.object) && is_object(t.edge_object), "a T-junction");
    for (const InsideOutBody& body : i.inside_out)
        require(!body.objects.empty() && std::all_of(body.objects.begin(), body.objects.end(), is_object),
                "an inside-out body");
    const auto is_material = [&](std::uint32_t number) {
        return number == no_index || number < i.scene.materials.size();
    };
    for (const BorderSummary& b : i.borders) {
        require(is_object(b.object_a) && is_object(b.object_b), "a border");
        require(is_material(b.material_a) && is_material(b.material_b), "the materials of a border");
    }
    for (const MatchedPair& p : i.matched.pairs)
        require(is_object(p.object_a) && is_object(p.object_b), "borders that match");
    require(!(i.matched.before.max_deg > 0 || i.matched.seam_deg > 0) || !i.matched.pairs.empty(),
            "the largest seam along borders");
    require(!(i.seams.seam_deg > 0) || !i.borders.empty(), "the border of its largest seam");
}

}  // namespace rakelight
