// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/environment_maps.h"

#include <algorithm>

#include "cpu_shading/material_views.h"

namespace rakelight::cpu_shading {
namespace {

/// All levels with their borders, which continue across the map's edges as the sphere does.
void pack_mirrored(const std::vector<OctahedralMap>& maps, EnvironmentMaps& to) {
    TextureView& view = to.mirrored_view;
    view = {};
    view.levels = int(maps.size());
    view.wrap_u = view.wrap_v = wrap_clamped;
    view.magnify_linear = view.minify_linear = 1;
    view.mip = mip_linear;
    std::size_t texels = 0;
    for (const OctahedralMap& map : maps) texels += std::size_t(map.size + 2) * std::size_t(map.size + 2);
    to.mirrored.reserve(4 * texels);
    for (std::size_t l = 0; l < maps.size(); ++l) {
        const int size = maps[l].size;
        view.width[l] = view.height[l] = size;
        view.stride[l] = size + 2;
        view.fixed_width[l] = view.fixed_height[l] = float(size) * 32768.0f;
        view.origin[l] = std::int32_t(to.mirrored.size() / 4) + size + 3;
        const auto first = to.mirrored.size();
        to.mirrored.resize(first + 4 * std::size_t(size + 2) * std::size_t(size + 2), 1.0f);
        float* texel = to.mirrored.data() + first;
        for (int y = -1; y <= size; ++y)
            for (int x = -1; x <= size; ++x, texel += 4) {
                const bool is_inside = x >= 0 && y >= 0 && x < size && y < size;
                const vec3& c = is_inside ? maps[l].at(x, y) : bordered_texel(maps[l], x, y);
                texel[0] = c.x, texel[1] = c.y, texel[2] = c.z;
            }
    }
    view.rgba32f = to.mirrored.data();
}

}  // namespace

std::shared_ptr<const shading::PackedEnvironment> CpuEnvironmentPacker::pack(const shading::EnvironmentImages& images,
                                                                             const ImageHandle& image,
                                                                             Context& context) const {
    auto out = std::make_shared<EnvironmentMaps>();
    if (!images.sky.levels.empty()) {
        out->sky = pack_texture(images.sky, {image, ColorSpace::srgb, Wrap::repeat, Wrap::clamp_to_edge},
                                MemoryCharge(context.memory()));
        out->sky_view = with_filters(*out->sky, {.wrap_v = Wrap::clamp_to_edge});
    }
    pack_mirrored(images.light.mirrored, *out);
    return out;
}

void set_environment(const Scene& scene, shading::EnvironmentCache& cache, bool follows_rays, MaterialViews& views,
                     Context& context) {
    const std::optional<shading::UsedEnvironment> used =
        cache.update(scene, CpuEnvironmentPacker(), follows_rays, context);
    views.environment = nullptr;
    if (!used) return;
    views.environment = used->packed;
    const auto& maps = static_cast<const EnvironmentMaps&>(*used->packed);
    static_cast<shading::EnvironmentFactors&>(views.environment_view) = used->factors;
    views.environment_view.specular = &maps.mirrored_view;
    views.environment_view.sky = maps.sky ? &maps.sky_view : nullptr;
}

}  // namespace rakelight::cpu_shading
