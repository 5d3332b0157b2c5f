// SPDX-License-Identifier: Apache-2.0
#include "bake/lightmap_texels.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "bake/high/surface_colors.h"
#include "bake/low/texel_owners.h"
#include "bake/padding.h"

namespace rakelight::bake {
namespace {

/// Samples a lit surface in texture space.
class LitTexels {
public:
    LitTexels(const LowSurface& surface, const TexelOwners& owners, const SurfaceColors& colors,
              const LightmapOptions& options, LightmapTexels& out)
        : surface_(surface), owners_(owners), colors_(colors), options_(options), out_(out) {}

    /// @return number of texels covered or touched by charts
    std::uint64_t fill(const OwnerBand& band) const {
        const std::size_t samples = std::size_t(options_.samples), width = std::size_t(options_.width);
        std::uint64_t texels = 0;
        for (std::size_t i = 0; i < std::size_t(band.rows) * width; ++i) {
            const int x = int(i % width), y = band.first_row + int(i / width);
            dvec3 sum{};
            int count = 0;
            std::uint32_t last = no_index;
            const auto add = [&](std::uint32_t triangle, dvec2 at) {
                sum = sum + color(triangle, at);
                last = triangle, ++count;
            };
            for (std::size_t s = 0; s < samples; ++s)
                if (const std::uint32_t owner = band.owner[i * samples + s]; owner != no_index)
                    add(owner, owners_.sample_at(x, y, int(s)));
            if (count == 0 && band.nearest[i] != no_index) add(band.nearest[i], {x + 0.5, y + 0.5});
            if (count == 0) continue;
            const std::size_t texel = std::size_t(y) * width + std::size_t(x);
            out_.color[texel] = cast<float>(sum / double(count));
            out_.material[texel] = surface_.mesh_of(last).material;
            ++texels;
        }
        return texels;
    }

private:
    dvec3 color(std::uint32_t triangle, dvec2 at) const {
        const MapTriangle on = on_map(surface_, triangle, options_.width, options_.height);
        const dvec2 a = on.at[1] - on.at[0], b = on.at[2] - on.at[0];
        const double samples = 0.5 * std::fabs(a.x * b.y - a.y * b.x) * options_.samples;
        const CornerWeights w = owners_.weights(triangle, at);
        const double weight[3] = {w[0], w[1], w[2]};
        return colors_.at(surface_.mesh_of(triangle), surface_.vertices(triangle).data(), weight,
                          std::max(samples, 1e-9));
    }

    const LowSurface& surface_;
    const TexelOwners& owners_;
    const SurfaceColors& colors_;
    const LightmapOptions& options_;
    LightmapTexels& out_;
};

void pad(LightmapTexels& texels, const LightmapOptions& options, Context& context) {
    if (options.padding == 0) return;
    std::vector<std::uint8_t> covered;
    covered.reserve(texels.material.size());
    for (const std::uint32_t material : texels.material) covered.push_back(material != no_index);
    const std::vector<std::uint32_t> nearest =
        nearest_covered(covered, options.width, options.height, options.padding, context);
    for (std::size_t i = 0; i < nearest.size(); ++i)
        if (nearest[i] != no_index)
            texels.color[i] = texels.color[nearest[i]], texels.material[i] = texels.material[nearest[i]];
}

}  // namespace

LightmapTexels lightmap_texels(const Scene& lit, std::uint32_t set, const LightmapOptions& options,
                               LightmapReport& report, Context& context) {
    const std::size_t count = std::size_t(options.width) * std::size_t(options.height);
    constexpr std::uint64_t own = sizeof(vec3) + 4, beside = 1 + 4 + 4;  // outside of charts: padding
    context.memory().check(count * (own + beside), "the lightmap");
    LightmapTexels out{.charge = MemoryCharge(context.memory(), count * own, "the lightmap")};
    out.color.resize(count), out.material.assign(count, no_index);
    const LowSurface surface(lit, set, context);
    const MapCharts charts = find_map_charts(surface, context);
    const TexelOwners owners(surface, charts, options.width, options.height, options.samples, context);
    const SurfaceColors colors(lit, context);
    const LitTexels texels(surface, owners, colors, options, out);
    std::mutex mutex;
    int bands = 0;
    context.parallel_for(std::size_t(owners.bands()), [&](std::size_t number) {
        const OwnerBand band = owners.band(int(number), context);
        const std::uint64_t filled = texels.fill(band);
        const std::lock_guard lock(mutex);
        report.texels += filled;
        context.progress("lightmap", double(++bands) / owners.bands());
    });
    report.charts = std::uint32_t(charts.is_mirrored.size());
    report.overlapping = owners.overlaps(context).charts;
    pad(out, options, context);
    return out;
}

}  // namespace rakelight::bake
