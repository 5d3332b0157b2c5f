// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <utility>

#include <rakelight/base/report.h>
#include <rakelight/render/render.h>
#include <rakelight/render/session.h>
#include <rakelight/scene/scene_queries.h>
#include <rakelight/scene/validate.h>
#include <rakelight_internal/base/text.h>

#include "base/format_text.h"
#include "engines/check_settings.h"
#include "engines/posed_arrays.h"
#include "prepare/prepare_scene.h"
#include "render/asked_scenes.h"
#include "render/drawable.h"
#include "render/engines.h"
#include "render/height_maps.h"
#include "render/lit_scenes.h"
#include "render/prepared_scene.h"
#include "scene/charge_arrays.h"
#include "scene/faults.h"
#include "scene/placement.h"
#include "scene/validate.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// What a rasterizer does not show of the materials.
void remark_missing_rays(const Scene& scene, const Engine& engine, Report& report) {
    if (engine.capabilities().rays) return;
    std::vector<bool> is_drawn(scene.materials.size(), false);
    for (const Node& node : scene.nodes)
        for (const std::uint32_t mesh : node.meshes)
            if (scene.meshes[mesh].material != no_index) is_drawn[scene.meshes[mesh].material] = true;
    std::size_t mirrors = 0, open = 0, layers = 0;
    for (std::size_t i = 0; i < is_drawn.size(); ++i) {
        const Material& m = scene.materials[i];
        if (!is_drawn[i] || m.model == MaterialModel::unlit) continue;
        const bool is_classical = m.model == MaterialModel::classical;
        mirrors += is_classical && m.classical.mirror != Mirror::none && m.classical.specular != vec3{};
        open += is_classical && m.classical.transmission != vec3{};
        layers += !is_classical && m.metallic_roughness.transmission > 0;
    }
    const std::string tail = ": engine " + engine.name() + " shows the surface alone, 'engine' trace follows rays";
    if (open > 0)
        report.add(Remark::dropped, scene.source, "", "light passes through " + counted(open, "material") + tail,
                   {"engine"});
    if (layers > 0)
        report.add(Remark::note, scene.source, "",
                   "light passes through " + counted(layers, "material") + ": under pbr engine " + engine.name() +
                       " shows the opaque surfaces behind the nearest one, 'engine' trace follows rays",
                   {"engine"});
    if (mirrors > 0)
        report.add(Remark::note, scene.source, "", counted(mirrors, "material mirrors", "materials mirror") + tail,
                   {"engine"});
}

}  // namespace

struct Session::State {
    std::unique_ptr<Engine> engine;
    Scene scene;             ///< as set; empty where a prepared one was, and of a single picture once it is prepared
    PrepareOptions options;  ///< likewise
    /// What pictures are drawn of: nothing, `scene`, a prepared one that is drawn as it is, the scene of a single picture.
    enum class Source { none, scene, prepared, single } source = Source::none;
    std::shared_ptr<const PreparedScene> prepared;  ///< of `scene`, or as set; null: not made yet
    std::shared_ptr<PreparedScene> single;          ///< likewise, of a single picture
    bool engine_has_single = false;                 ///< `single` is empty then
    std::vector<Light> single_lights;               ///< those of its scene, then
    std::shared_ptr<const PreparedScene> taken;     ///< what the engine has
    LitScenes lit;
    AskedScenes asked;
    /// What `scene` was made of, if by show().
    struct Shown {
        std::shared_ptr<const Scene> loaded;
        PictureRequest request;
        std::vector<ClipTime> clips;
        bool operator==(const Shown&) const = default;
    };
    std::optional<Shown> shown;

    void begin(Source from) {
        scene = {}, prepared.reset(), single.reset(), shown.reset();
        engine_has_single = false, source = from;
    }
    const Scene& current() const;
    std::shared_ptr<const PreparedScene> prepare_single(const Shot& shot, Context& context);
    void hand_over_single(const Shot& shot, Context& context);
    void warm_up(const Shot& shot, Session& session, Context& context);
};

Session::Session(const std::string& engine) : Session(make_engine(engine)) {}
Session::Session(std::unique_ptr<Engine> engine) : state_(std::make_unique<State>()) {
    if (!engine) throw Error(ErrorCode::usage, "a session needs an engine");
    state_->engine = std::move(engine);
}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const Engine& Session::engine() const { return *state_->engine; }

void Session::set(Scene scene, const PrepareOptions& options) {
    State& s = *state_;
    validate_changes(scene, s.scene);
    const bool is_alike = s.source == State::Source::scene && s.prepared && s.options == options &&
                          are_prepared_alike(scene, s.scene) && (s.prepared->bound || scene.pose == s.scene.pose);
    const bool has_moved = !(scene.pose == s.scene.pose);
    if (!is_alike) check_drawable(scene);
    std::shared_ptr<const PreparedScene> next;
    if (is_alike) next = s.prepared;  // if it has moved, it is posed when it is asked for
    if (is_alike && !has_moved && !have_same_surroundings(scene, s.scene)) {
        auto other = std::make_shared<PreparedScene>(*s.prepared);
        take_surroundings(*other, scene);
        next = std::move(other);
    }
    s.begin(State::Source::scene);
    s.scene = std::move(scene);
    s.options = options;
    s.prepared = std::move(next);
}

const Scene& Session::show(const std::shared_ptr<const Scene>& loaded, const PictureRequest& request,
                           std::span<const ClipTime> clips, Context& context) {
    State& s = *state_;
    State::Shown next{loaded, surfaces_of(request), {clips.begin(), clips.end()}};
    next.request.fog = request.fog, next.request.prepare = request.prepare;
    if (s.shown == next) return s.scene;
    set(asked(loaded, request, clips, context), request.prepare);
    s.shown = std::move(next);
    return s.scene;
}

Scene Session::asked(const std::shared_ptr<const Scene>& loaded, const PictureRequest& request,
                     std::span<const ClipTime> clips, Context& context) {
    if (!loaded) throw Error(ErrorCode::usage, "there is no scene to draw");
    return state_->asked.at(loaded, request, clips, context);
}

void Session::set(std::shared_ptr<const PreparedScene> scene) {
    if (!scene) throw Error(ErrorCode::usage, "there is no prepared scene to draw");
    state_->begin(State::Source::prepared);
    state_->prepared = std::move(scene);
}

const Scene& Session::set_single(Scene scene, const PrepareOptions& options) {
    validate(scene);
    check_drawable(scene);
    State& s = *state_;
    s.begin(State::Source::single);
    s.scene = std::move(scene), s.options = options;
    return s.scene;
}

/// What is drawn, before it is prepared where that is still to be done.
const Scene& Session::State::current() const {
    switch (source) {
        case Source::none:
            break;
        case Source::scene:
            return scene;
        case Source::prepared:
            return prepared->scene;
        case Source::single:
            return engine_has_single ? engine->scene() : single ? single->scene : scene;
    }
    throw Error(ErrorCode::usage, "the session has no scene");
}

std::shared_ptr<const PreparedScene> Session::prepared(const RenderSettings& settings, Context& context) {
    return prepared_for({.settings = settings}, context);
}

std::shared_ptr<const PreparedScene> Session::prepared_for(const Shot& shot, Context& context) {
    const RenderSettings& settings = shot.settings;
    check_settings(settings);
    State& s = *state_;
    const Scene& current = s.current();
    if (shot.lights) validate_lights(*shot.lights, current.nodes.size());
    if (s.source == State::Source::single) return s.prepare_single(shot, context);
    const bool is_ready = s.source == State::Source::prepared ||
                          (s.prepared && s.prepared->options == options_for(s.options, settings, s.scene));
    if (!is_ready) s.prepared = make_prepared(s.scene, s.options, settings, context);
    if (s.source == State::Source::scene && s.prepared->bound && !(s.prepared->pose == s.scene.pose)) {
        std::shared_ptr<PreparedScene> posed = make_posed(*s.prepared, s.scene.pose, context);
        take_surroundings(*posed, s.scene);
        s.prepared = std::move(posed);
    }
    if (settings.method == RayMethod::radiosity) return s.lit.of(s.prepared, shot.lights, settings.radiosity, context);
    return s.prepared;
}

std::shared_ptr<const PreparedScene> Session::State::prepare_single(const Shot& shot, Context& context) {
    if (engine_has_single) return std::make_shared<const PreparedScene>(PreparedScene{.scene = engine->scene()});
    if (single) return single;
    const Source was = std::exchange(source, Source::none);  // what fails leaves none
    single = make_prepared(std::exchange(scene, {}), options, shot.settings, context);
    single->bound.reset();  // there are no other poses
    if (shot.settings.method == RayMethod::radiosity)
        single = lit_by_radiosity(*std::exchange(single, nullptr), shot.lights, shot.settings.radiosity, context);
    source = was;
    return single;
}

/// With all vertices: there is nothing to be kept in bind pose.
void Session::State::hand_over_single(const Shot& shot, Context& context) {
    if (!engine_has_single) {
        (void)prepare_single(shot, context);
        const std::shared_ptr<PreparedScene> given = std::exchange(single, nullptr);
        begin(Source::none), taken.reset();
        single_lights = given->scene.lights;
        given->scene.lights = lights_of(given->scene, shot);
        engine->prepare(given->posed_.take(std::move(*given), context), context);
        source = Source::single, engine_has_single = true;
        remark_missing_rays(engine->scene(), *engine, context.report());
    }
    std::vector<Light> lights = lights_of(engine->scene(), single_lights, shot);
    if (lights != engine->scene().lights) engine->set_lights(std::move(lights));
}

/// The engine has the scene, with the lights of the picture.
void Session::State::warm_up(const Shot& shot, Session& session, Context& context) {
    if (source == Source::single) {
        if (shot.lights) validate_lights(*shot.lights, current().nodes.size());
        return hand_over_single(shot, context);
    }
    const std::shared_ptr<const PreparedScene> ready = session.prepared_for(shot, context);
    if (taken && are_drawn_alike(*taken, *ready)) {
        taken = ready;
        std::vector<Light> lights = lights_of(ready->scene, shot);
        if (lights != engine->scene().lights) engine->set_lights(std::move(lights));
        return;
    }
    taken.reset();  // what fails leaves the engine with another scene, or none
    const bool is_unposed = ready->poses && engine->poses_vertices();
    Scene drawn = charged_copy(is_unposed ? ready->scene : ready->posed(context), context);
    drawn.lights = lights_of(ready->scene, shot);
    if (is_unposed)
        engine->prepare_unposed(std::move(drawn), ready->poses, context);
    else
        engine->prepare(std::move(drawn), context);
    taken = ready;
    remark_missing_rays(engine->scene(), *engine, context.report());
}

void Session::warm_up(const Shot& shot, Context& context) {
    State& s = *state_;
    check_settings(shot.settings);
    check_abilities(s.engine->name(), s.engine->capabilities(), shot.settings);
    check_camera(shot.camera, s.current().nodes.size(), CameraUse::in_scene);
    s.warm_up(shot, *this, context);
}

RenderStats Session::render(const Shot& shot, Sink& sink, Context& context) {
    warm_up(shot, context);
    State& s = *state_;
    const Camera camera = camera_in_world(s.engine->scene(), shot.camera, aspect_of(shot.settings));
    return s.engine->render(camera, shot.settings, sink, context);
}

RenderStats Session::render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) {
    return render({camera, settings, {}}, sink, context);
}

const Scene& scene_of(const PreparedScene& prepared) {
    Context context;
    return prepared.posed(context);
}

const Scene& unposed_scene_of(const PreparedScene& prepared) { return prepared.scene; }

}  // namespace rakelight
