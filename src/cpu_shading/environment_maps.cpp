// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/environment_maps.h"

#include <algorithm>

#include "cpu_shading/material_views.h"

namespace rakelight::cpu_shading {
namespace {

/// All levels with their borders, which go on across the map's edges as the sphere does.
void pack_mirrored(const std::vector<OctahedralMap>& maps, EnvironmentMaps& to) {
    TextureView& view = to.mirrored_view;
    view = {};
    view.levels = int(maps.size());
    view.wrap_u = view.wrap_v = wrap_clamped;
    view.magnify_linear = view.minify_linear = 1;
    view.mip = mip_linear;
    for (std::size_t l = 0; l < maps.size(); ++l) {
        const int size = maps[l].size;
        view.width[l] = view.height[l] = size;
        view.stride[l] = size + 2;
        view.fixed_width[l] = view.fixed_height[l] = float(size) * 32768.0f;
        view.origin[l] = std::int32_t(to.mirrored.size() / 4) + size + 3;
        for (int y = -1; y <= size; ++y)
            for (int x = -1; x <= size; ++x) {
                const vec3 c = bordered_texel(maps[l], x, y);
                to.mirrored.insert(to.mirrored.end(), {c.x, c.y, c.z, 1.0f});
            }
    }
    view.rgba32f = to.mirrored.data();
}

}  // namespace

std::shared_ptr<const shading::PackedEnvironment> CpuEnvironmentPacker::pack(const shading::EnvironmentImages& images,
                                                                             const ImageHandle& image,
                                                                             Context& context) const {
    auto out = std::make_shared<EnvironmentMaps>();
    out->sky = pack_texture(images.sky, {image, ColorSpace::srgb, Wrap::repeat, Wrap::clamp_to_edge},
                            MemoryCharge(context.memory()));
    out->sky_view = with_filters(*out->sky, {.wrap_v = Wrap::clamp_to_edge});
    pack_mirrored(images.light.mirrored, *out);
    return out;
}

void set_environment(const Scene& scene, shading::EnvironmentCache& cache, MaterialViews& views, Context& context) {
    const std::optional<shading::UsedEnvironment> used = cache.update(scene, CpuEnvironmentPacker(), context);
    views.environment = nullptr;
    if (!used) return;
    views.environment = used->packed;
    const auto& maps = static_cast<const EnvironmentMaps&>(*used->packed);
    static_cast<shading::EnvironmentFactors&>(views.environment_view) = used->factors;
    views.environment_view.specular = &maps.mirrored_view;
    views.environment_view.sky = &maps.sky_view;
}

}  // namespace rakelight::cpu_shading
