// SPDX-License-Identifier: Apache-2.0
// The texels of a material's maps at a vector of points. Maps that lie alike find their place once. Per instruction set.
#pragma once
#include "cpu_shading/kernels/job.h"

namespace rakelight::cpu_shading::RL_ISA {

inline const TexCoords& texcoords_of(const TextureSlot& slot, const ShadingPoint& p) {
    return p.texcoords[slot.texcoord_set == 0 ? 0 : 1];
}

/// @param are_moved  the texture coordinates are a relief's, of no plane
inline void find_map_place(const MaterialJob& job, bool are_moved, ShadingPoint& p) {
    const MaterialView& m = *job.material;
    p.anisotropy = job.anisotropy;
    p.shared_maps = p.anisotropy > 1 || are_moved ? 0 : m.shared_maps;
    if (p.shared_maps == 0) return;
    const TextureSlot& slot = m.map[role_base_color];
    TexCoords room;
    const TexCoords& c = transformed(slot, texcoords_of(slot, p), room);
    find_footprint(*slot.view, c, level_of_detail(*slot.view, c), slot.view->minify_linear != 0, p.footprint);
}

inline bool is_shared(const ShadingPoint& p, int role) { return (p.shared_maps >> role & 1u) != 0; }

/// The texel of a map that is there.
template <class Kind>
inline vec4 texel(const Job<Kind>& job, int role, const ShadingPoint& p) {
    const TextureSlot& slot = job.material().map[role];
    if (is_shared(p, role)) return sample<Kind::formats>(*slot.view, p.footprint);
    const TexCoords& c = texcoords_of(slot, p);
    return p.anisotropy > 1 ? sample_anisotropic<Kind::formats>(slot, c, p.anisotropy) : sample<Kind::formats>(slot, c);
}

/// The neutral texel of a map that does not exist.
template <class Kind>
inline vec4 texel_or_white(const Job<Kind>& job, int role, const ShadingPoint& p) {
    return job.material().map[role].view != nullptr ? texel(job, role, p) : vec4(real(1.0f));
}

}  // namespace rakelight::cpu_shading::RL_ISA
