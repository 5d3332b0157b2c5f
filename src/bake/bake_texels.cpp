// SPDX-License-Identifier: Apache-2.0
#include "bake/bake_texels.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "bake/cage_rays.h"
#include "bake/high/surface_colors.h"
#include "bake/low/tangent_frame.h"
#include "bake/low/texel_owners.h"
#include "bake/sky_rays.h"
#include "base/format_text.h"

namespace rakelight::bake {
namespace {

constexpr double longer[] = {1, 2, 4};  ///< larger cages tried if the proposed one misses

/// Value of a sample, or mean over a texel.
struct Values {
    dvec3 normal{};
    double height = 0, curvature = 0, occlusion = 0;
    dvec3 light{};
};

/// Of texels: see BakeReport.
struct Counts {
    std::uint64_t texels = 0, missed = 0, beyond = 0;
};

/// HIGH with light as its colors, for rays.
class LitSurface {
public:
    LitSurface(const Scene& scene, Context& context) : surface_(scene, false, context), colors_(scene, context) {}
    std::optional<dvec3> light(const LowPoint& low, double distance) const {
        const auto hit = meet_from_cage(surface_, low, distance);
        if (!hit) return std::nullopt;
        const Mesh& mesh = surface_.mesh_of(hit->high.hit);
        return colors_.at(mesh, &mesh.indices[3 * std::size_t(hit->high.hit.triangle)], hit->high.hit.weight, 1);
    }

private:
    HighSurface surface_;
    SurfaceColors colors_;
};

class TexelBaker {
public:
    TexelBaker(const HighSurface& high, const LowSurface& low, const LitSurface* lit, const TexelOwners& owners,
               const BakeOptions& options, BakeResult& result)
        : high_(high), low_(low), lit_(lit), owners_(owners), options_(options), result_(result) {
        while (side_ * side_ < options.rays) ++side_;
        reach_ = options.occlusion_distance > 0 ? options.occlusion_distance : high.diagonal();
        for (const BakedMap& map : result.maps) {
            wants_curvature_ |= map.map == BakeMap::curvature;
            wants_occlusion_ |= map.map == BakeMap::occlusion;
        }
    }

    Counts bake(const OwnerBand& band, std::vector<std::uint8_t>& covered, const Context& context) const {
        Counts counts;
        const std::size_t samples = std::size_t(options_.samples), width = std::size_t(result_.width);
        for (std::size_t i = 0; i < std::size_t(band.rows) * width; ++i) {
            const int x = int(i % width), y = band.first_row + int(i / width);
            const std::uint32_t* owner = &band.owner[i * samples];
            Sum sum{std::uint64_t(y) * width + std::uint64_t(x)};
            for (std::size_t s = 0; s < samples; ++s)
                if (owner[s] != no_index) add(owner[s], owners_.sample_at(x, y, int(s)), s, sum);
            if (sum.tried == 0 && band.nearest[i] != no_index) add(band.nearest[i], {x + 0.5, y + 0.5}, 0, sum);
            if (sum.tried == 0) continue;
            context.throw_if_cancelled();
            covered[sum.texel] = 1;
            ++counts.texels;
            counts.missed += sum.met == 0;
            counts.beyond += sum.met > 0 && std::fabs(sum.of.height) > sum.met * result_.report.distance;
            put(sum);
        }
        return counts;
    }

private:
    struct Sum {
        std::uint64_t texel;
        int tried = 0, met = 0, lit = 0;
        Values of{};
        dvec3 own{};  ///< of LOW, without a hit
    };

    void add(std::uint32_t triangle, dvec2 at, std::size_t sample, Sum& sum) const {
        const LowPoint low = point_of(low_.triangle(triangle), owners_.weights(triangle, at));
        ++sum.tried;
        sum.own = sum.own + written(low, normalize_or(low.normal, low.cage));
        std::optional<CageHit> hit;
        for (const double factor : longer) {
            hit = meet_from_cage(high_, low, factor * result_.report.distance);
            if (hit || !result_.report.is_proposed) break;
        }
        if (!hit) return;
        if (lit_) add_light(low, sum);
        ++sum.met;
        sum.of.normal = sum.of.normal + written(low, hit->high.normal);
        sum.of.height += hit->height;
        if (wants_curvature_) sum.of.curvature += high_.curvature(hit->high.hit);
        if (wants_occlusion_)
            sum.of.occlusion +=
                open_sky(high_, hit->high, side_, reach_, sum.texel * std::uint64_t(options_.samples) + sample);
    }

    void add_light(const LowPoint& low, Sum& sum) const {
        for (const double factor : longer)
            if (const auto light = lit_->light(low, factor * result_.report.distance)) {
                sum.of.light = sum.of.light + *light;
                ++sum.lit;
                return;
            }
    }

    /// Converts a unit normal from world space to the space of the map; unit.
    dvec3 written(const LowPoint& low, dvec3 normal) const {
        constexpr dvec3 even{0, 0, 1};
        if (options_.space == BakeSpace::object) return normalize_or(low.to_object * normal, even);
        const TangentFrame unit = unit_frame(low.normal, low.tangent, low.handedness);
        dvec3 out;
        if (options_.normalize_frames ||
            !in_frame(interpolated_frame(low.normal, low.tangent, low.handedness), normal, out))
            out = {dot(unit.tangent, normal), dot(unit.bitangent, normal), dot(unit.normal, normal)};
        return normalize_or(out, even);
    }

    void put(const Sum& sum) const {
        const double scale = sum.met > 0 ? 1.0 / sum.met : 0;
        dvec3 normal = normalize_or(sum.met > 0 ? sum.of.normal : sum.own, dvec3{0, 0, 1});
        if (options_.space == BakeSpace::tangent && normal.z < 0)  // glTF 2.0, section 3.9.3: z is not negative
            normal = normalize_or(dvec3{normal.x, normal.y, 0}, dvec3{0, 0, 1});
        for (BakedMap& map : result_.maps) {
            float* to = &map.values[std::size_t(sum.texel) * std::size_t(map.channels)];
            switch (map.map) {
                case BakeMap::normal:
                    for (std::size_t k = 0; k < 3; ++k) to[k] = float(normal[k]);
                    break;
                case BakeMap::height:
                    *to = float(sum.of.height * scale);
                    break;
                case BakeMap::curvature:
                    *to = float(sum.of.curvature * scale);
                    break;
                case BakeMap::occlusion:
                    *to = sum.met > 0 ? float(sum.of.occlusion * scale) : 1.0f;
                    break;
                case BakeMap::light:
                    for (std::size_t k = 0; k < 3; ++k) to[k] = float(sum.of.light[k] / std::max(sum.lit, 1));
                    break;
            }
        }
    }

    const HighSurface& high_;
    const LowSurface& low_;
    const LitSurface* lit_;
    const TexelOwners& owners_;
    const BakeOptions& options_;
    BakeResult& result_;
    int side_ = 1;
    double reach_ = 0;
    bool wants_curvature_ = false, wants_occlusion_ = false;
};

bool has(const BakeResult& result, BakeMap wanted) {
    return std::ranges::any_of(result.maps, [&](const BakedMap& map) { return map.map == wanted; });
}

/// Results of the bands, in any order.
struct Found {
    std::mutex mutex;
    Counts counts;
    int bands = 0;
};

/// Known before the rays, so that a bake that is wrong can be stopped early.
void report_charts(const MapCharts& charts, const Overlaps& overlaps, const std::string& file, BakeReport& r,
                   Report& report) {
    r.charts = std::uint32_t(charts.is_mirrored.size());
    r.mirrored = std::uint32_t(std::ranges::count(charts.is_mirrored, std::uint8_t(1)));
    r.overlapping = overlaps.charts, r.overlapping_texels = overlaps.texels;
    if (r.overlapping > 0)
        report.add(Remark::warning, file, {},
                   format_text("{} of {} charts lie on others or on themselves: {} texels are baked once, for the "
                               "first that is not mirrored",
                               r.overlapping, r.charts, r.overlapping_texels));
    if (r.mirrored > 0)
        report.add(Remark::note, file, {}, format_text("{} of {} charts are mirrored", r.mirrored, r.charts));
}

}  // namespace

std::vector<std::uint8_t> bake_texels(const Scene& high_scene, const Scene& low_scene, const Scene* lit_scene,
                                      const BakeOptions& options, BakeResult& result, Context& context) {
    const HighSurface high(high_scene, has(result, BakeMap::curvature), context);
    std::optional<LitSurface> lit;
    if (lit_scene) lit.emplace(*lit_scene, context);
    const LowSurface low(low_scene, 0, context);
    BakeReport& report = result.report;
    report.is_proposed = options.distance <= 0;
    report.distance = report.is_proposed ? proposed_distance(high, low, context) : options.distance;
    report.curvature_radius = options.curvature_radius > 0 ? options.curvature_radius : high.diagonal() / 50;
    const MapCharts charts = find_map_charts(low, context);
    const TexelOwners owners(low, charts, result.width, result.height, options.samples, context);
    report_charts(charts, owners.overlaps(context), low_scene.source, report, context.report());
    const TexelBaker baker(high, low, lit ? &*lit : nullptr, owners, options, result);
    std::vector<std::uint8_t> covered(std::size_t(result.width) * std::size_t(result.height), 0);
    Found found;
    context.parallel_for(std::size_t(owners.bands()), [&](std::size_t number) {
        const OwnerBand band = owners.band(int(number), context);
        const Counts counts = baker.bake(band, covered, context);
        const std::lock_guard lock(found.mutex);
        found.counts.texels += counts.texels, found.counts.missed += counts.missed,
            found.counts.beyond += counts.beyond;
        context.progress("bake", double(++found.bands) / owners.bands());
    });
    report.texels = found.counts.texels, report.missed = found.counts.missed, report.beyond = found.counts.beyond;
    return covered;
}

}  // namespace rakelight::bake
