// SPDX-License-Identifier: Apache-2.0
// Stages of baking: checks, LOW with texture coordinates and frames, HIGH with shading normals, texels, padding. Then maps as pictures.
#include <rakelight/bake/bake.h>
#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/validate.h>

#include "bake/bake_texels.h"
#include "bake/check_settings.h"
#include "bake/low/make_coordinates.h"
#include "bake/padding.h"
#include "base/format_text.h"
#include "math/color.h"
#include "prepare/variants.h"
#include "scene/materials/texture_uses.h"

namespace rakelight {
namespace bake {
namespace {

struct MapKind {
    BakeMap map;
    const char* name;
    int channels;
    float even[3];        ///< value outside of charts
    Component component;  ///< component type of integer pictures
};

const MapKind& kind_of(BakeMap map) {
    // Name, channels, value outside of charts, component type of integer pictures.
    static constexpr MapKind kinds[] = {{BakeMap::normal, "normal", 3, {0, 0, 1}, Component::u8},
                                        {BakeMap::height, "height", 1, {0, 0, 0}, Component::u16},
                                        {BakeMap::curvature, "curvature", 1, {0, 0, 0}, Component::u8},
                                        {BakeMap::occlusion, "occlusion", 1, {1, 0, 0}, Component::u8},
                                        {BakeMap::light, "light", 3, {0, 0, 0}, Component::u8}};
    return kinds[std::size_t(map)];
}

bool is_length(double v) { return std::isfinite(v) && v >= 0; }

void check(const BakeOptions& o) {
    require(!o.maps.empty(), "maps", "no map is named");
    for (const BakeMap map : o.maps) {
        require(std::size_t(map) < all_bake_maps().size(), "maps", "is no map");
        require(std::ranges::count(o.maps, map) == 1, "maps", "a map is named twice");
    }
    check_map(o);
    require(is_length(o.distance), "distance", "must be more than 0 and finite");
    require(o.rays >= 1 && o.rays <= 4096, "rays", "must be 1 to 4096");
    require(is_length(o.occlusion_distance), "occlusion-distance", "must be more than 0 and finite");
    require(is_length(o.curvature_radius), "curvature-radius", "must be more than 0 and finite");
    require(o.crease_angle_rad >= 0 && o.crease_angle_rad <= pi, "crease-angle", "must be 0 to 180 degrees");
    require(o.high_normals == NormalSource::automatic || o.high_normals == NormalSource::model, "high-normals",
            "must be auto or model");
    require(o.low_normals == NormalSource::automatic || o.low_normals == NormalSource::model, "normals",
            "must be auto or model");
}

Scene at_rest(const Scene& scene, Context& context) {
    validate(scene);
    return is_posable(scene) ? posed_scene(scene, context) : scene;
}

bool lacks_coordinates(const Scene& scene) {
    return std::ranges::any_of(drawn_instances(scene), [&](const Instance& instance) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        return mesh.texcoords.empty() || mesh.texcoords[0].empty();
    });
}

/// Removes LOW's bump maps, which the baked map replaces.
void drop_bumps(Scene& scene) {
    for (Material& material : scene.materials) {
        material.normal_texture = material.height_texture = {};
        material.bump = Bump::automatic;
    }
}

/// @param report gets the computed coordinates
Scene with_coordinates(Scene low, const BakeOptions& options, BakeReport& report, Context& context) {
    if (!options.make_coordinates && !lacks_coordinates(low)) return low;
    bool had_textures = false;
    for (Material& material : low.materials)
        for_each_texture_use(material, [&](TextureUse& use) {
            had_textures |= bool(use);
            use = {};
        });
    MadeCoordinates made =
        make_coordinates(std::move(low), {options.width, options.height, options.chart_margin}, context);
    if (had_textures)
        context.report().add(Remark::dropped, low.source, {}, "its textures, which do not fit new texture coordinates");
    report.made_coordinates = made.meshes, report.texels_per_meter = made.scale;
    return std::move(made.scene);
}

/// Normals of the file, or computed over all objects; MikkTSpace tangents of texture coordinate set 0.
Scene prepared_low(Scene low, const BakeOptions& options, Context& context) {
    for (Mesh& mesh : low.meshes) {
        const bool keeps = options.low_normals == NormalSource::automatic && !mesh.normals.empty();
        mesh.normal_choice = NormalChoice{.source = keeps ? NormalSource::file : NormalSource::model};
        mesh.tangents = {};
        mesh.subdivision.reset();
    }
    for (Material& material : low.materials) {  // tangents are those of set 0
        MetallicRoughnessParameters& p = material.metallic_roughness;
        p.clearcoat_normal_texture = p.anisotropy_texture = {};
    }
    return prepare_scene(std::move(low),
                         {.weight = options.weight,
                          .crease_angle_rad = options.crease_angle_rad,
                          .creases = options.creases,
                          .tangents = TangentMode::mikktspace,
                          .all_tangents = true,
                          .tessellate = true},
                         context);
}

bool gives_light(const Scene& scene) {
    return !scene.lights.empty() || (scene.environment && scene.environment->is_light) ||
           std::ranges::any_of(scene.materials, [](const Material& m) { return !(m.emission == vec3{}); });
}

/// HIGH with irradiance for the light map; empty without such a map.
std::optional<Scene> lit_high(const Scene& high, const BakeOptions& options, BakeReport& report, Context& context) {
    if (std::ranges::count(options.maps, BakeMap::light) == 0) return std::nullopt;
    if (!gives_light(high))
        throw Error(ErrorCode::bad_file, "has no lights, no environment and nothing that emits, for a map of light", {},
                    "give it some, in a world file")
            .with_file(high.source)
            .naming({"maps"});
    return with_radiosity(high, {.elements = options.light_elements}, report.radiosity, context, LitColors::irradiance);
}

void make_maps(const BakeOptions& options, BakeResult& result, Context& context) {
    const std::uint64_t texels = std::uint64_t(options.width) * std::uint64_t(options.height);
    std::uint64_t bytes = 0;
    for (const BakeMap map : options.maps) bytes += texels * 4 * std::uint64_t(kind_of(map).channels);
    context.memory().check(bytes + 9 * texels, "baked maps");  // and the coverage of texels
    result.charge = MemoryCharge(context.memory(), bytes, "baked maps");
    result.width = options.width, result.height = options.height;
    for (const BakeMap map : options.maps) {
        const MapKind& kind = kind_of(map);
        BakedMap& made = result.maps.emplace_back(BakedMap{map, kind.channels});
        made.values.resize(std::size_t(texels) * std::size_t(kind.channels));
        for (std::size_t i = 0; i < made.values.size(); ++i) made.values[i] = kind.even[i % std::size_t(kind.channels)];
    }
}

void pad(const std::vector<std::uint8_t>& covered, const BakeOptions& options, BakeResult& result, Context& context) {
    if (options.padding == 0) return;
    const std::vector<std::uint32_t> nearest =
        nearest_covered(covered, result.width, result.height, options.padding, context);
    for (BakedMap& map : result.maps) {
        const auto channels = std::size_t(map.channels);
        for (std::size_t i = 0; i < nearest.size(); ++i)
            if (nearest[i] != no_index && nearest[i] != i)
                std::copy_n(&map.values[nearest[i] * channels], channels, &map.values[i * channels]);
    }
}

void add_remarks(const Scene& high, const Scene& low, const BakeReport& r, bool is_height_wanted, Context& context) {
    constexpr std::uint64_t few = 1000;  // a share of hits below 1 / few counts as none
    if ((r.texels - r.missed) * few <= r.texels)
        throw Error(ErrorCode::bad_file,
                    r.texels == 0          ? "no chart covers a texel of the map"
                    : r.missed == r.texels ? "no ray from it meets '" + one_line(high.source, 80) + "'"
                                           : format_text("only {} of {} texels meet '{}'", r.texels - r.missed,
                                                         r.texels, one_line(high.source, 80)),
                    {},
                    r.texels == 0 ? "make the map larger"
                                  : "models have to lie at the same place; a larger 'distance' reaches farther")
            .with_file(low.source)
            .naming({"distance"});
    Report& report = context.report();
    if (r.missed > 0)
        report.add(
            Remark::warning, low.source, {},
            format_text(
                "{} of {} texels show the model itself: no ray met the other one; a larger 'distance' reaches farther",
                r.missed, r.texels),
            {"distance"});
    if (r.beyond > 0 && is_height_wanted)
        report.add(Remark::warning, low.source, {},
                   format_text("{} of {} texels lie beyond the proposed cage: heights in PNG end there; a larger "
                               "'distance' holds them",
                               r.beyond, r.texels),
                   {"distance"});
}

/// A map's value scaled to 0..1 for integer pictures, or unchanged for float pictures.
class Coding {
public:
    Coding(const BakeResult& result, const BakedMap& map, const BakeOptions& options, bool is_float) {
        if (map.map == BakeMap::normal)
            scale_ = 0.5, offset_ = 0.5, turns_ = options.green_down && options.space == BakeSpace::tangent;
        if (is_float) return;
        is_color_ = map.map == BakeMap::light;
        if (map.map == BakeMap::height) scale_ = 0.5 / result.report.distance, offset_ = 0.5;
        if (map.map == BakeMap::curvature) scale_ = 0.5 * result.report.curvature_radius, offset_ = 0.5;
    }
    double operator()(float value, std::size_t channel) const {
        const double v = turns_ && channel == 1 ? -double(value) : double(value);
        return is_color_ ? double(srgb_from_linear(value)) : v * scale_ + offset_;
    }

private:
    double scale_ = 1, offset_ = 0;
    bool turns_ = false, is_color_ = false;
};

}  // namespace
}  // namespace bake

const char* name_of(BakeMap map) noexcept { return bake::kind_of(map).name; }

Component component_of(BakeMap map) noexcept { return bake::kind_of(map).component; }

std::span<const BakeMap> all_bake_maps() noexcept {
    static constexpr BakeMap all[] = {BakeMap::normal, BakeMap::height, BakeMap::curvature, BakeMap::occlusion,
                                      BakeMap::light};
    return all;
}

bool can_bake() noexcept {
#ifdef RL_HAVE_TRACE
    return true;
#else
    return false;
#endif
}

BakeResult bake_maps(const Scene& high, const Scene& low, const BakeOptions& options, Context& context) {
    bake::check(options);
    if (!can_bake())
        throw Error(ErrorCode::failed, "this build follows no rays, which baking needs", {},
                    "build it with -DRAKELIGHT_TRACE=ON");
    BakeResult result;
    context.progress("prepare", 0);
    const Scene source =
        prepare_scene(bake::at_rest(high, context), {.normals = options.high_normals, .tessellate = true}, context);
    Scene target = bake::at_rest(low, context);
    bake::drop_bumps(target);
    if (drawn_instances(target).empty())
        throw Error(ErrorCode::bad_file, "has no triangles to be baked to").with_file(low.source);
    bake::make_maps(options, result, context);
    target = bake::with_coordinates(std::move(target), options, result.report, context);
    result.low = bake::prepared_low(std::move(target), options, context);
    const std::optional<Scene> lit = bake::lit_high(source, options, result.report, context);
    context.progress("bake", 0);
    const std::vector<std::uint8_t> covered =
        bake::bake_texels(source, result.low, lit ? &*lit : nullptr, options, result, context);
    const bool has_heights = std::ranges::count(options.maps, BakeMap::height) > 0;
    bake::add_remarks(high, low, result.report, has_heights, context);
    bake::pad(covered, options, result, context);
    return result;
}

Pixels picture_of(const BakeResult& result, const BakedMap& map, const BakeOptions& options, Component component,
                  Context& context) {
    Pixels pixels{.width = result.width, .height = result.height, .channels = map.channels, .component = component};
    pixels.is_linear = component == Component::f32 || map.map != BakeMap::light;
    pixels.charge = share(MemoryCharge(context.memory(), map.values.size() * size_of(component), "a baked map"));
    pixels.bytes.resize(map.values.size() * size_of(component));
    const bake::Coding coding(result, map, options, component == Component::f32);
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        const double value = coding(map.values[i], i % std::size_t(map.channels));
        std::byte* const to = &pixels.bytes[i * size_of(component)];
        const auto code = [&](double most) { return std::floor(std::clamp(value, 0.0, 1.0) * most + 0.5); };
        if (component == Component::f32) {
            const float v = float(value);
            std::memcpy(to, &v, sizeof v);
        } else if (component == Component::u16) {
            const auto v = std::uint16_t(code(65535));
            std::memcpy(to, &v, sizeof v);
        } else {
            *to = std::byte(std::uint8_t(code(255)));
        }
    }
    return pixels;
}

}  // namespace rakelight
