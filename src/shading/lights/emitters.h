// SPDX-License-Identifier: Apache-2.0
// The triangles of a scene that emit light, as something to choose points from: more often where more light comes from.
#pragma once
#include <vector>

#include <rakelight/engines/engine.h>

#include "shading/draw_list.h"
#include "shading/lights/alias_table.h"

namespace rakelight::shading {

/// Whether some of it may. Factors of unlit materials have no emission.
bool emits(const DrawMaterial& material);

/// A point on a triangle that emits.
struct EmitterSample {
    std::uint32_t draw = no_index;  ///< into DrawList::draws; `no_index`: nothing emits
    std::uint32_t triangle = 0;     ///< of the draw's mesh
    float weight[3] = {};           ///< of the triangle's corners at the point, sum 1
    vec3 position;                  ///< [m] world axes, about the given origin
    vec3 normal;                    ///< unit, of the triangle in the world, towards its front
    float size = 0;                 ///< [m] largest coordinate of the triangle, in world axes about the given origin
    float pdf_area = 0;             ///< [1/m^2] of this point among all, the choice of the triangle included
    bool shines_back = false;       ///< from its back too; its front always does
};

/// Which triangles emit, and how likely each is chosen: by its power, with its mean emission over its texture coordinates
/// (Shirley, Wang & Zimmerman 1996, "Monte Carlo Techniques for Direct Lighting Calculations"). Instances count each.
/// A triangle does not emit where its material is unlit, where its texture is black, where it has no area or is not finite.
/// Immutable, thread-safe; the same bits whatever the threads. 16 bytes per triangle of draws that emit, 4 bytes per draw.
class Emitters {
public:
    Emitters() = default;
    /// @param list      must outlive this
    /// @param textures  as make_draw_list() left it
    /// @throws Error bad_file: over the memory budget, or 2^32 triangles emit; failed: cancelled
    Emitters(const DrawList& list, const TextureCache& textures, FrontFace front_face, Context& context);

    bool empty() const noexcept { return triangles_.empty(); }
    double power() const noexcept {
        return power_;
    }  ///< pi * area * luminance of the emission, summed over all sides that shine

    /// A point by the area of its triangle (Turk 1990, "Generating Random Points in Triangles").
    /// @param choice  0..1, 1 excluded: which triangle; the more bits the better (AliasTable::sample())
    /// @param u       0..1 each: where on it
    /// @param origin  [m] world
    EmitterSample sample(double choice, vec2 u, dvec3 origin) const noexcept;

    /// [1/m^2] EmitterSample::pdf_area of any point of that triangle; 0 where it is never chosen.
    float pdf_area(std::uint32_t draw, std::uint32_t triangle) const noexcept {
        const std::uint32_t first = draw < first_of_draw_.size() ? first_of_draw_[draw] : no_index;
        return first == no_index ? 0 : pdf_area_[first + triangle];
    }
    /// Whether both sides of a draw shine, else its front alone does: that of culling_of() in draw_choices.h, whatever
    /// RenderSettings::cull says.
    bool shines_back(std::uint32_t draw) const { return list_->material(list_->draws[draw]).two_sided; }

private:
    struct Part {
        std::uint32_t draw, first;  ///< its first triangle, of those of all parts
    };
    void add_parts(const DrawList& list, Context& context);
    void weigh(const TextureCache& textures, Context& context);
    template <class Work>
    void for_parts(Context& context, const Work& work) const;
    const Part& part_of(std::uint32_t index) const;
    double front_sign(const Draw& draw) const { return draw.mirrored != clockwise_ ? -1 : 1; }

    MemoryCharge charge_;  ///< pays for the tables
    const DrawList* list_ = nullptr;
    bool clockwise_ = false;
    double power_ = 0;
    std::vector<Part> parts_;                   ///< the draws that emit, and one behind the last
    std::vector<std::uint32_t> first_of_draw_;  ///< [draws] Part::first or no_index; empty where nothing emits
    AliasTable triangles_;
    std::vector<float> pdf_area_;  ///< [1/m^2] of each
};

}  // namespace rakelight::shading
