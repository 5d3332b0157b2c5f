// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/scene/environment.h"

#include <algorithm>

namespace rakelight::opengl {
namespace {

void put_map(const OctahedralMap& map, int left, MipLevel& atlas) {
    for (int y = -1; y <= map.size; ++y)
        for (int x = -1; x <= map.size; ++x) {
            const vec3 c = bordered_texel(map, x, y);
            atlas.rgba32f[std::size_t(y + 1) * std::size_t(atlas.width) + std::size_t(left + x)] = {c.x, c.y, c.z, 1};
        }
}

void set_filters(bool has_levels, GLint wrap_u, GLint last_level) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last_level);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, has_levels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_u);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

std::shared_ptr<const shading::PackedEnvironment> EnvironmentLevelPacker::pack(const shading::EnvironmentImages& images,
                                                                               const ImageHandle&, Context&) const {
    auto out = std::make_shared<EnvironmentLevels>();
    out->sky = images.sky.levels;
    out->is_srgb = images.sky.is_srgb;
    int width = 0, height = 0;
    for (const OctahedralMap& map : images.light.mirrored) {
        out->places.push_back({float(width + 1), 1, float(map.size)});
        width += map.size + 2, height = std::max(height, map.size + 2);
    }
    out->mirrored = {width, height, {}, std::vector<vec4>(std::size_t(width) * std::size_t(height))};
    for (std::size_t i = 0; i < out->places.size(); ++i)
        put_map(images.light.mirrored[i], int(out->places[i].x), out->mirrored);
    return out;
}

void EnvironmentStore::update(const std::optional<shading::UsedEnvironment>& used, const Driver& driver,
                              const std::string& source, Report& report) {
    if (!used) {
        *this = {};
        return;
    }
    const auto levels = std::static_pointer_cast<const EnvironmentLevels>(used->packed);
    if (levels == levels_) {
        factors_ = used->factors;
        return;
    }
    EnvironmentStore made;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, made.mirrored_.get());
    upload_levels({levels->mirrored}, 0, false);
    set_filters(false, GL_CLAMP_TO_EDGE, 0);
    glBindTexture(GL_TEXTURE_2D, made.sky_.get());
    const std::size_t skipped = levels_beyond(levels->sky, driver.texture_size);
    if (skipped > 0)
        report.add(Remark::warning, source, {}, "the environment " + drawn_smaller(levels->sky[0], driver));
    upload_levels(levels->sky, skipped, levels->is_srgb);
    set_filters(true, GL_REPEAT, GLint(levels->sky.size() - skipped) - 1);
    check_gl("the environment");
    made.sky_height_ = levels->sky[skipped].height;
    made.factors_ = used->factors;
    made.levels_ = levels;
    *this = std::move(made);
}

}  // namespace rakelight::opengl
