// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/textures/environment_maps.h"

#include <algorithm>

#include "engines/raster/kernels/full_types.h"

namespace rakelight::raster {
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

std::shared_ptr<const shading::PackedEnvironment> SoftEnvironmentPacker::pack(const shading::EnvironmentImages& images,
                                                                              const ImageHandle& image,
                                                                              Context& context) const {
    auto out = std::make_shared<EnvironmentMaps>();
    out->sky = pack_texture(images.sky, {image, ColorSpace::srgb, Wrap::repeat, Wrap::clamp_to_edge},
                            MemoryCharge(context.memory()));
    out->sky_view = with_filters(*out->sky, {.wrap_v = Wrap::clamp_to_edge});
    pack_mirrored(images.light.mirrored, *out);
    return out;
}

void set_environment(DrawList& list, shading::EnvironmentCache& cache, Context& context) {
    const std::optional<shading::UsedEnvironment> used = cache.update(list.scene, SoftEnvironmentPacker(), context);
    list.environment = nullptr;
    if (!used) return;
    list.environment = used->packed;
    const auto& maps = static_cast<const EnvironmentMaps&>(*used->packed);
    static_cast<shading::EnvironmentFactors&>(list.environment_view) = used->factors;
    list.environment_view.specular = &maps.mirrored_view;
    list.environment_view.sky = &maps.sky_view;
}

}  // namespace rakelight::raster
