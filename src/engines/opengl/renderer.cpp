// SPDX-License-Identifier: Apache-2.0
#include "engines/opengl/renderer.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "base/format_text.h"
#include "engines/channel_arrays.h"
#include "engines/empty_pixel.h"
#include "engines/opengl/picture/blended_check.h"
#include "lighting/albedo_tables.h"
#include "scene/materials/material_table.h"
#include "scene/placement.h"
#include "scene/validate.h"
#include "shading/lights/lights.h"
#include "shading/remarks/corner_remarks.h"
#include "shading/shading_choice.h"

namespace rakelight::opengl {
namespace {

// Names of passes, as RenderStats::gpu_passes has them.
constexpr const char *shadow_pass = "shadow maps", *surface_pass = "surfaces", *blended_pass = "blended surfaces",
                     *channel_pass = "data channels";

}  // namespace

Renderer::Renderer() : driver_(ask_driver()) { make_albedos(); }

void Renderer::make_albedos() {
    const lighting::AlbedoTables t = lighting::albedo_tables();
    const int columns = lighting::albedo_columns, rows = lighting::albedo_rows, sheen = lighting::sheen_rows;
    std::vector<float> numbers(t.lobe_loss, t.lobe_loss + rows * columns);
    numbers.insert(numbers.end(), t.grazing, t.grazing + rows * columns);
    numbers.insert(numbers.end(), t.sheen, t.sheen + sheen * columns);
    for (int i = 0; i < 2; ++i) numbers.insert(numbers.end(), t.loss, t.loss + columns);
    glActiveTexture(GL_TEXTURE0);
    set_texels(albedos_, GL_R32F, GL_RED, GL_FLOAT, columns, int(numbers.size()) / columns, numbers.data());
    check_gl("the tables of albedos");
}

void Renderer::prepare(GivenScene given, Context& context) {
    validate_changes(given.scene, list_.scene);
    list_ = {};  // its textures may go: what fails from here on leaves an empty scene
    unposed_.clear();
    forget_picture();
    TakenScene taken =
        take_scene(std::move(given), !driver_.poses_meshes, std::move(cache_), std::move(environments_), context);
    keep_meshes(taken.list.scene, taken.poses);
    upload(taken, Clock::time_point::max(), context);
    take(std::move(taken), context);
}

void Renderer::take(TakenScene scene, Context& context) {
    const std::optional<Environment>& environment = scene.list.scene.environment;
    const std::string file = environment && environment->image ? environment->image->file : std::string();
    environment_.update(scene.environment, driver_, file, context.report());
    keep_meshes(scene.list.scene, scene.poses);
    textures_.keep_only(wishes_of(scene.list, scene.cache));
    list_ = std::move(scene.list);
    unposed_ = std::move(scene.poses);
    cache_ = std::move(scene.cache);
    environments_ = std::move(scene.environments);
    forget_picture();
    order_is_wrong_ = false;
}

void Renderer::keep_meshes(const Scene& scene, const geometry::MeshPoses& poses) {
    meshes_.keep_only(scene, poses);
    poses_.keep_only(poses);
}

void Renderer::forget_uploads() {
    keep_meshes(list_.scene, unposed_);
    textures_.keep_only(wishes_of(list_, cache_));
}

void Renderer::forget_picture() {
    maps_.clear();
    seen_.clear(), blended_.clear();
    meter_.reset();
}

void Renderer::set_lights(std::vector<Light> lights) {
    validate_lights(lights, list_.scene.nodes.size());
    if (lights == list_.scene.lights) return;
    list_.scene.lights = std::move(lights);
    maps_.clear();
}

PictureState Renderer::picture_state() {
    const bool is_lit = environment_ && list_.scene.environment && list_.scene.environment->is_light;
    return {.list = list_,
            .cache = cache_,
            .textures = textures_,
            .settings = settings_,
            .view = view_,
            .shading = shading_,
            .lights = lights_,
            .has_environment = is_lit,
            .has_shadows = !light_shadows_.empty(),
            .units = driver_.texture_units - engine_units,
            .behind = has_behind_ ? &behind_factors_ : nullptr};
}

void Renderer::begin_picture(const Camera& camera, const RenderSettings& settings, RenderStats& stats,
                             Context& context) {
    settings_ = settings;
    not_finite_ = covered_ = 0;
    dropped_maps_ = dropped_of_ = 0;
    seen_.assign(list_.draws.size(), false);
    meter_.reset();
    programs_.begin_picture();
    if (programs_.set_user(settings)) maps_.clear();
    view_ = shading::picture_camera_of(list_, camera, settings);
    pose_measured_meshes(context);
    shading_ = shading::choose_shading(list_, settings, view_, context);
    pose_meshes(context);
    const dvec3 eye = view_.camera_to_world[3].xyz();
    light_parameters_ = shading::make_lights(list_.scene, list_.node_to_world, eye);
    update_shadows(settings, eye, light_parameters_, stats, context);
    draw_behind(context);
}

std::vector<Renderer::KeptMaps> Renderer::draw_shadow_maps(const RenderSettings& settings, Context& context) {
    shading::check_shadow_memory(list_.scene.lights, settings, context.memory());
    std::vector<KeptMaps> maps;
    std::vector<int> faces;
    for (std::size_t i = 0; i < list_.scene.lights.size(); ++i) {
        if (!shading::casts_shadow(list_.scene.lights[i])) continue;
        maps.push_back({i, shading::shadow_cameras(list_, list_.scene.lights[i], settings), {}, {}});
        faces.push_back(int(maps.back().cameras.size()));
    }
    if (maps.empty()) return maps;
    const std::vector<ShadowAtlas::Place> places = shadows_.reserve(faces, settings.shadow_size);
    RenderSettings of_map = shading::map_settings(settings.shadow_size);
    of_map.vertex_text = settings.vertex_text;
    for (std::size_t m = 0; m < maps.size(); ++m) {
        maps[m].place = places[m];
        for (std::size_t f = 0; f < maps[m].cameras.size(); ++f) {
            maps[m].view = shading::picture_camera_of(list_, maps[m].cameras[f].camera, of_map);
            draw_shadow_map(maps[m].view, of_map, places[m], int(f), context);
        }
    }
    return maps;
}

void Renderer::update_shadows(const RenderSettings& settings, dvec3 eye, std::vector<lighting::LightParameters>& lights,
                              RenderStats& stats, Context& context) {
    light_shadows_.clear();
    const bool is_wanted = shading::has_shadow_maps(list_, settings, context.report());
    if (!is_wanted) maps_.clear();
    if (is_wanted && (maps_.empty() || map_size_ != settings.shadow_size || map_filter_ != settings.shadow_filter)) {
        maps_.clear();  // what is thrown from here on leaves none
        maps_ = draw_shadow_maps(settings, context);
        map_size_ = settings.shadow_size, map_filter_ = settings.shadow_filter;
    }
    if (maps_.empty()) return shadows_.forget();
    for (const KeptMaps& m : maps_) {
        lights[m.light].shadow = std::int32_t(light_shadows_.size());
        light_shadows_.push_back(
            {shading::shadow_factors(m.cameras[0], m.view, m.cameras.size(), settings, eye), m.place.x, m.place.y});
        stats.shadow_maps += m.cameras.size();
        stats.shadow_bytes +=
            m.cameras.size() * std::uint64_t(map_size_) * std::uint64_t(map_size_) * shading::shadow_texel_bytes;
    }
}

void Renderer::draw_shadow_map(const shading::PictureCamera& view, const RenderSettings& settings,
                               ShadowAtlas::Place place, int face, Context& context) {
    const std::vector<Shading> unlit(list_.draws.size(), Shading::unlit);
    const PictureState state = picture_state();
    const LightTable no_lights;
    const PictureState of_map{.list = state.list,
                              .cache = state.cache,
                              .textures = state.textures,
                              .settings = settings,
                              .view = view,
                              .shading = unlit,
                              .lights = no_lights,
                              .units = state.units};
    const PictureTools with = tools();
    PictureDrawer drawer(with, of_map, {0, 0, settings.width, settings.height});
    const float texels = float(0.5 * view.width * view.scale_x);
    drawer.set_map_texels(view.orthographic ? -texels : texels);
    const PassMeter::Pass pass(meter_, shadow_pass);
    shadows_.begin(place, face,
                   std::bit_cast<std::uint32_t>(view.orthographic ? shading::nothing_on_parallel_map : 0.0f),
                   far_depth());
    drawer.begin();
    for (std::uint32_t d = 0; d < list_.draws.size(); ++d) {
        context.throw_if_cancelled();
        if (list_.material(list_.draws[d]).factors.blend || drawer.is_outside(d)) continue;
        drawer.draw(d, draw_state(of_map, d, Output::shadow, false));
    }
    check_gl("a shadow map");
}

void Renderer::draw_blended(const PictureDrawer& drawer, const PictureState& state,
                            const std::vector<std::uint32_t>& draws, Context& context) {
    blended_ = blending_order(list_, view_, draws, context);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    std::map<std::uint32_t, DrawState> states;
    for (const std::uint32_t d : draws)
        note_dropped(d, states.emplace(d, draw_state(state, d, Output::color, false)).first->second);
    const PassMeter::Pass pass(meter_, blended_pass);
    for (const BlendedRun& run : blended_) {
        context.throw_if_cancelled();
        const DrawState& of = states.at(run.draw);
        const Program& program = drawer.use(run.draw, of);
        if (of.features.from_triangles) {
            for (const std::uint32_t t : run.triangles) drawer.draw_triangles(of, program, t, 1);
            continue;
        }
        const Mesh& mesh = list_.scene.meshes[list_.draws[run.draw].mesh];
        std::vector<std::uint32_t> indices;
        indices.reserve(3 * run.triangles.size());
        for (const std::uint32_t t : run.triangles)
            for (std::size_t k = 0; k < 3; ++k) indices.push_back(mesh.indices[3 * std::size_t(t) + k]);
        GLint own = 0;
        glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &own);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, stream_.get());
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(indices[0])), indices.data(),
                     GL_STREAM_DRAW);
        drawer.draw_triangles(of, program, 0, std::uint32_t(run.triangles.size()));
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, GLuint(own));
    }
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void Renderer::draw_surfaces(const PictureDrawer& drawer, const PictureState& state,
                             std::vector<std::uint32_t>& blended, Context& context) {
    const PassMeter::Pass pass(meter_, surface_pass);
    for (std::uint32_t d = 0; d < list_.draws.size() && settings_.surfaces; ++d) {
        context.throw_if_cancelled();
        if (drawer.is_outside(d)) continue;
        seen_[d] = true;
        if (list_.material(list_.draws[d]).factors.blend) {
            blended.push_back(d);
            continue;
        }
        const DrawState of = draw_state(state, d, Output::color, false);
        note_dropped(d, of);
        drawer.draw(d, of);
    }
}

void Renderer::note_dropped(std::uint32_t draw, const DrawState& state) {
    if (state.dropped != 0 && dropped_maps_ == 0) dropped_maps_ = state.dropped, dropped_of_ = draw;
}

void Renderer::draw_colors(const PictureDrawer& drawer, const PictureState& state, Context& context) {
    drawer.begin();
    if (environment_ && list_.scene.environment && list_.scene.environment->is_background) drawer.draw_sky();
    std::vector<std::uint32_t> blended;
    draw_surfaces(drawer, state, blended, context);
    blended_.clear();
    if (!blended.empty()) draw_blended(drawer, state, blended, context);
    check_gl("the picture");
}

void Renderer::draw_channel_group(const PictureDrawer& drawer, const PictureState& state, Output group,
                                  bool wants_triangles, Context& context) {
    channel_target_.begin(group, far_depth());
    drawer.begin();
    if (group == Output::count) {
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    for (std::uint32_t d = 0; d < list_.draws.size() && settings_.surfaces; ++d) {
        context.throw_if_cancelled();
        if (drawer.is_outside(d) || list_.material(list_.draws[d]).factors.blend) continue;
        drawer.draw(d, draw_state(state, d, group, wants_triangles));
    }
    glDisable(GL_BLEND);
    if (group != Output::user_terms && Marks::are_in(list_, settings_))
        marks_.draw_channels(drawer, state, group, target_, far_depth());
}

std::vector<std::array<vec4, 4>> Renderer::user_terms(int x, int y, Context& context) {
    constexpr int most_lights = 8;
    channel_target_.reserve(1, 1);
    const PictureState state = picture_state();
    const PictureTools with = tools();
    std::vector<std::array<vec4, 4>> terms;
    for (int light = 0; light < std::min(lights_.count(), most_lights); ++light) {
        PictureDrawer drawer(with, state, {x, y, 1, 1});
        drawer.set_term_light(light);
        draw_channel_group(drawer, state, Output::user_terms, false, context);
        terms.push_back(channel_target_.user_terms());
    }
    return terms;
}

void Renderer::draw_channels(Window pixels, ChannelArrays& to, Context& context) {
    clear(to, settings_.channels, std::size_t(pixels.width) * std::size_t(pixels.height));
    channel_target_.reserve(pixels.width, pixels.height);
    const PictureState state = picture_state();
    const PictureTools with = tools();
    const PictureDrawer drawer(with, state, pixels);
    for_each_group(settings_.channels, [&](Output group, bool wants_triangles) {
        {
            const PassMeter::Pass pass(meter_, channel_pass);
            draw_channel_group(drawer, state, group, wants_triangles, context);
        }
        channel_target_.read(group, settings_.channels, view_.camera_to_world[3].xyz(), to);
    });
}

void Renderer::draw_part(Window pixels, Target& to, Context& context) {
    lights_.set(light_parameters_, light_shadows_, view_, pixels);
    const PictureState state = picture_state();
    const PictureTools with = tools();
    const PictureDrawer drawer(with, state, pixels);
    to.begin(empty_pixel(settings_), far_depth());
    draw_colors(drawer, state, context);
    to.resolve();
    if (Marks::are_in(list_, settings_)) marks_.draw(drawer, state, to, meter_);
    check_gl("the picture");
}

void Renderer::read_part(std::span<vec4> to) {
    target_.read(to);
    not_finite_ += to_straight_alpha(to, empty_pixel(settings_));
    covered_ += counter_.count(target_, far_depth());
}

void Renderer::remark_dropped_maps(Report& report) const {
    if (dropped_maps_ == 0) return;
    std::string names;
    for (const TextureRole& role : texture_roles())
        if ((dropped_maps_ >> role.number & 1u) != 0) names += (names.empty() ? "" : ", ") + std::string(role.name);
    report.add(Remark::warning, list_.scene.source, list_.scene_material(list_.material(list_.draws[dropped_of_])).name,
               format_text("textures left out: {}: this OpenGL driver samples {} textures at once", names,
                           driver_.texture_units));
}

void Renderer::end_picture(RenderStats& stats, Context& context) {
    if (seen_.size() != list_.draws.size()) return;  // of another scene
    const auto is_lit_at_corners = [this](std::uint32_t d) {
        return seen_[d] && (shading_[d] == Shading::flat || shading_[d] == Shading::gouraud) &&
               !list_.material(list_.draws[d]).factors.unlit;
    };
    shading::remark_corner_shading(list_, settings_, is_lit_at_corners, context.report());
    remark_dropped_maps(context.report());
    remark_depths(context.report());
    for (std::size_t d = 0, end = 0; d < list_.draws.size(); d = end) {  // draws of an object follow each other
        bool is_seen = false;
        for (end = d; end < list_.draws.size() && list_.draws[end].node == list_.draws[d].node; ++end) {
            is_seen = is_seen || seen_[end];
            if (seen_[end]) stats.triangles_in += list_.scene.meshes[list_.draws[end].mesh].triangle_count();
        }
        stats.objects_outside += !is_seen;
    }
    meter_.finish(stats.gpu_passes);
    stats.pixels_not_finite = not_finite_;
    stats.depth_passes = meter_.samples(surface_pass);
    stats.pixels_covered = covered_;
    stats.samples_covered = settings_.samples == 1 ? covered_ : 0;
    stats.pixels_shaded = covered_ + meter_.samples(blended_pass) / std::uint64_t(settings_.samples);
    stats.pixels_marked = meter_.samples(Marks::pass_name);
    if (not_finite_ > 0)
        context.report().add(Remark::warning, list_.scene.source, {},
                             std::to_string(not_finite_) + " color values were not finite and are shown black");
}

void Renderer::remark_order(Report& report) {
    const bool is_moved = !settings_.vertex_text.empty();  // to where only the GPU knows
    if (is_moved) return;
    order_is_wrong_ = order_is_wrong_ || has_wrong_order(list_, view_, settings_, blended_);
    if (!order_is_wrong_) return;
    report.add(Remark::warning, list_.scene.source, {},
               "transparent surfaces cross or overlap in a circle; this engine sorts whole triangles, so "
               "some are drawn over nearer ones; the engines soft and trace sort at every pixel");
}

void Renderer::remark_depths(Report& report) const {
    if (driver_.has_reversed_depth || view_.orthographic || list_.bounds.empty()) return;
    double far = 0;
    for (int corner = 0; corner < 8; ++corner)
        far = std::max(far, -transform_point(view_.world_to_camera, list_.bounds.corner(corner)).z);
    // A step of the textbook's depth at a distance d is d^2 / (near 2^24): there d / 1000.
    const double unsure = 0x1p24 / 1000 * view_.z_near;
    if (unsure >= std::min(far, view_.z_far)) return;
    report.add(
        Remark::warning, list_.scene.source, {},
        format_text(
            "with this OpenGL driver (no clip control) and near at {:.3g} m, depths beyond {:.3g} m are coarser than a "
            "thousandth of the distance, and surfaces may cover nearer ones; a larger 'near' or another 'engine' helps",
            view_.z_near, unsure),
        {"near", "engine"});
}

}  // namespace rakelight::opengl
