// SPDX-License-Identifier: Apache-2.0
// Stages: parts of the scene -> patches -> shots -> elements, refined at shadow boundaries -> lit scene.
#include <rakelight/base/report.h>
#include <rakelight/radiosity/radiosity.h>
#include <rakelight_internal/base/text.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <string>

#include "base/format_text.h"
#include "radiosity/cut.h"
#include "radiosity/gather.h"
#include "radiosity/lit_scene.h"
#include "radiosity/shadow_borders.h"
#include "radiosity/shoot.h"
#include "scene/materials/texture_uses.h"

namespace rakelight::radiosity {
namespace {

/// Minimum number of elements per patch, which limits the number of pairs.
constexpr std::uint64_t elements_a_patch = 10;
constexpr std::size_t min_patches = 100, max_patches = 2000;
/// Shares of the elements before the first subdivision at shadow boundaries, and after each.
constexpr double first_share = 0.25;
constexpr double share_after[] = {0.35, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95, 1.0};
/// [diagonals of the scene] offset of ray ends from surfaces.
constexpr double gap_share = 2e-6;

std::vector<bool> used_materials(const Scene& scene, const std::vector<Part>& parts) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Part& part : parts) used[part.material] = true;
    return used;
}

bool is_more_than_diffuse(const Material& m) {
    if (m.model == MaterialModel::classical)
        return m.classical.mirror != Mirror::none || !(m.classical.transmission == vec3{});
    return m.metallic_roughness.metallic > 0 || m.metallic_roughness.transmission > 0;
}

void remark_what_is_left_out(const Scene& scene, const std::vector<bool>& used, Report& report) {
    std::size_t shiny = 0, clear = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
        shiny += used[i] && is_more_than_diffuse(scene.materials[i]);
        clear += used[i] && scene.materials[i].alpha_mode != AlphaMode::opaque;
    }
    const auto note = [&](const std::string& text) {
        report.add(Remark::note, scene.source, "", "radiosity: " + text, {"method"});
    };
    if (shiny > 0) note(counted(shiny, "material") + " of metal, mirror or glass: only what they reflect diffusely");
    if (clear > 0) note(counted(clear, "material") + " with alpha hold light up as if opaque");
    const auto is_ambient = [](const Light& light) { return light.type == LightType::ambient; };
    if (std::ranges::any_of(scene.lights, is_ambient))
        note("ambient light is left out, what it stands for is worked out");
    if (!scene.animations.empty()) note("the light is that of one moment, clips are left out");
}

/// The requested number, or more if the scene has more triangles.
/// @param sides  of them
std::uint64_t max_elements(const Scene& scene, const RadiositySettings& s, std::uint64_t sides, Report& report) {
    const std::string limit = std::to_string(max_radiosity_elements);
    if (s.elements < 1 || s.elements > max_radiosity_elements)
        throw Error(ErrorCode::usage, "must be 1 to " + limit).about("radiosity-elements");
    if (sides > std::uint64_t(max_radiosity_elements))
        throw Error(ErrorCode::bad_file, format_text("radiosity is for scenes of up to {} triangles, and this one has "
                                                     "{}, both sides of two-sided ones counted",
                                                     limit, sides));
    if (sides <= std::uint64_t(s.elements)) return std::uint64_t(s.elements);
    const std::uint64_t most = std::min(sides + sides / 2, std::uint64_t(max_radiosity_elements));
    report.add(
        Remark::note, scene.source, "",
        format_text(
            "radiosity: up to {} elements, since the scene has {} triangles, both sides of two-sided ones counted",
            most, sides),
        {"radiosity-elements"});
    return most;
}

/// The light of elements over the rounds of refinement.
class Refinement {
public:
    Refinement(const CutScene& cut, std::vector<geometry::FineMesh> meshes, const Gather& gather, Context& context)
        : meshes(std::move(meshes)), cut_(cut), gather_(gather), context_(context) {
        elements = cut_.elements_of(this->meshes, context_);
        light.resize(elements.size());
        std::vector<std::uint32_t> all(elements.size());
        std::iota(all.begin(), all.end(), 0u);
        gather_all(elements, gather_, light, all, context_);
    }

    /// @return false: no refinement necessary
    bool run_round(std::uint64_t most) {
        const EdgeSet edges = shadow_borders(cut_.parts, meshes, elements, light, 0.1 * gather_.mean_luminance(), most);
        if (edges.empty()) return false;
        const std::vector<geometry::FineMesh> before = meshes;
        for (geometry::FineMesh& mesh : meshes) std::iota(mesh.source_triangle.begin(), mesh.source_triangle.end(), 0u);
        geometry::halve_edges(
            meshes, [&](dvec3 a, dvec3 b) { return edges.holds(a, b); }, std::uint64_t(max_radiosity_elements),
            context_);
        const Elements old = std::exchange(elements, cut_.elements_of(meshes, context_));
        take_over(before, old);
        return true;
    }

    std::vector<geometry::FineMesh> meshes;
    Elements elements;
    std::vector<dvec3> light;  ///< [elements] irradiance / pi

private:
    /// Unsplit triangles keep their light.
    void take_over(const std::vector<geometry::FineMesh>& before, const Elements& old) {
        const std::vector<dvec3> known = std::exchange(light, std::vector<dvec3>(elements.size()));
        std::vector<std::uint32_t> wanted;
        for (std::uint32_t m = 0; m < meshes.size(); ++m) {
            const auto count = std::uint32_t(meshes[m].indices.size() / 3);
            const auto old_count = std::uint32_t(before[m].indices.size() / 3);
            for (std::uint32_t side = 0; side < cut_.parts[m].sides(); ++side)
                for (std::uint32_t t = 0; t < count; ++t) {
                    const std::uint32_t source = meshes[m].source_triangle[t];
                    const std::uint32_t to = elements.base[m] + side * count + t;
                    const auto from = meshes[m].indices.begin() + 3 * std::ptrdiff_t(t);
                    if (std::equal(from, from + 3, before[m].indices.begin() + 3 * std::ptrdiff_t(source)))
                        light[to] = known[old.base[m] + side * old_count + source];
                    else
                        wanted.push_back(to);
                }
        }
        gather_all(elements, gather_, light, wanted, context_);
    }

    const CutScene& cut_;
    const Gather& gather_;
    Context& context_;
};

Scene solve(Scene scene, const RadiositySettings& settings, RadiosityReport& report, Context& context,
            LitColors shown) {
    name_default_material(scene);
    const std::vector<Part> parts = lit_parts(scene);
    const std::vector<bool> used = used_materials(scene, parts);
    const std::vector<geometry::FineMesh> whole = placed_meshes(scene, parts, context);
    const std::uint64_t sides = count_sides(parts, whole);
    const std::uint64_t most = max_elements(scene, settings, sides, context.report());
    remark_what_is_left_out(scene, used, context.report());
    const ColorMaps colors(scene, used, context);
    const CutScene cut{scene, parts, colors};
    const std::size_t wanted = std::clamp<std::size_t>(most / elements_a_patch, min_patches, max_patches);
    PatchLevel level = cut_to_patches(cut, whole, wanted, sides + (most - sides) / 4, context);
    const raytrace::SurfaceRays rays(scene, context);
    const double diagonal = rays.list().bounds.diagonal();
    const FormFactors form_factors(level.elements, level.patches, rays, gap_share * diagonal);
    const DirectLight direct(scene, rays, gap_share * diagonal, 2 * diagonal, context);
    std::vector<dvec3> radiance =
        shoot(level.elements, level.patches, form_factors, direct, settings.unshot, report, context);

    const auto share_of = [&](double share) { return sides + std::uint64_t(share * double(most - sides)); };
    cut_evenly(parts, level.meshes, level.edge, share_of(first_share), context);
    const Gather gather(level.patches, std::move(radiance), form_factors, direct);
    Refinement fine(cut, std::move(level.meshes), gather, context);
    for (const double share : share_after) report.rounds += fine.run_round(share_of(share)) ? 1 : 0;
    report.patches = std::uint32_t(level.patches.list.size());
    report.elements = std::uint32_t(fine.elements.size());
    return lit_scene(scene, parts, fine.meshes, fine.elements, fine.light, colors, shown, context);
}

}  // namespace
}  // namespace rakelight::radiosity

namespace rakelight {

Scene with_radiosity(Scene scene, const RadiositySettings& settings, RadiosityReport& report, Context& context,
                     LitColors colors) {
    const auto begin = std::chrono::steady_clock::now();
    report = {};
    Scene out = radiosity::solve(std::move(scene), settings, report, context, colors);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return out;
}

}  // namespace rakelight
