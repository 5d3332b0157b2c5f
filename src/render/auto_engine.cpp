// SPDX-License-Identifier: Apache-2.0
#include "render/auto_engine.h"

#include <span>
#include <utility>

#include "engines/posed_arrays.h"
#include "engines/raster/raster_engine.h"
#include "render/engines.h"
#include "scene/charge_arrays.h"
#ifdef RL_HAVE_OPENGL
#include "engines/opengl/opengl_engine.h"
#endif

namespace rakelight {
namespace {

/// Hands on all that it gets and is asked, and knows whether a picture was begun.
class WatchedSink final : public Sink {
public:
    explicit WatchedSink(Sink& to) : to_(to) {}
    bool has_begun() const { return has_begun_; }

    void begin(int width, int height, Window window, std::uint32_t channels) override {
        has_begun_ = true;
        to_.begin(width, height, window, channels);
    }
    void tile(const Tile& tile) override { to_.tile(tile); }
    void end_pass(int pass) override { to_.end_pass(pass); }
    int rows_at_once() const override { return to_.rows_at_once(); }
    void rows_done(int first, int rows) override { to_.rows_done(first, rows); }
    bool wants_partial() const override { return to_.wants_partial(); }
    bool wants_srgb8() const override { return to_.wants_srgb8(); }
    DisplayRows display_rows(const Window& area) override { return to_.display_rows(area); }
    void display_tile(const Tile& tile, std::span<const std::uint32_t> srgb8) override {
        to_.display_tile(tile, srgb8);
    }

private:
    Sink& to_;
    bool has_begun_ = false;
};

class AutoEngine final : public Engine {
public:
    /// @param gpu  null: there is none, for a reason
    AutoEngine(std::unique_ptr<Engine> gpu, std::string why)
        : gpu_(std::move(gpu)), soft_(raster::make_engine()), why_(std::move(why)) {}

    std::string name() const override { return draws_on_gpu_ ? gpu_->name() : soft_->name(); }
    EngineCapabilities capabilities() const override {
        EngineCapabilities can = soft_->capabilities();
        if (gpu_) can.user_lighting = gpu_->capabilities().user_lighting;
        return can;
    }

    void prepare(Scene scene, Context& context) override { prepare_unposed(std::move(scene), nullptr, context); }
    bool poses_vertices() const override { return gpu_ && gpu_->poses_vertices(); }
    void prepare_unposed(Scene scene, std::shared_ptr<const geometry::MeshPoses> poses, Context& context) override {
        draws_on_gpu_ = gpu_ != nullptr;
        poses_ = std::move(poses);
        if (!draws_on_gpu_ && !is_said_) say("it uses engine soft: " + why_, Remark::note, scene.source, context);
        is_said_ = true;
        if (draws_on_gpu_) {
            try {
                return prepare_on_gpu(scene, context);
            } catch (const Error& error) {
                give_up(error, scene.source, context);
            }
        }
        soft_->prepare(posed(std::move(scene), context), context);
    }

    const Scene& scene() const override { return draws_on_gpu_ ? gpu_->scene() : soft_->scene(); }

    void set_lights(std::vector<Light> lights) override {
        (draws_on_gpu_ ? *gpu_ : *soft_).set_lights(std::move(lights));
    }

    RenderStats render(const Camera& camera, const RenderSettings& settings, Sink& sink, Context& context) override {
        if (draws_on_gpu_ && can_draw(gpu_->capabilities(), settings)) {
            WatchedSink watched(sink);
            try {
                return gpu_->render(camera, settings, watched, context);
            } catch (const Error& error) {
                if (watched.has_begun()) throw;
                Scene scene = charged_copy(gpu_->scene(), context);
                give_up(error, scene.source, context);
                check_abilities(soft_->name(), soft_->capabilities(), settings);
                soft_->prepare(posed(std::move(scene), context), context);
            }
        } else if (draws_on_gpu_) {
            check_abilities(soft_->name(), soft_->capabilities(), settings);
            say("it uses engine soft for what engine gl cannot do", Remark::note, scene().source, context);
            soft_->prepare(posed(charged_copy(gpu_->scene(), context), context), context);
            draws_on_gpu_ = false;
        }
        return soft_->render(camera, settings, sink, context);
    }

private:
    void prepare_on_gpu(const Scene& scene, Context& context) {
        gpu_->prepare_unposed(charged_copy(scene, context), poses_, context);
    }
    /// The scene as soft takes it: meshes posed by the GPU are posed again on the processor.
    Scene posed(Scene scene, Context& context) const {
        return poses_ ? with_posed_arrays(std::move(scene), *poses_, context) : scene;
    }
    static void say(const std::string& what, Remark remark, const std::string& source, Context& context) {
        context.report().add(remark, source, "", "engine auto: " + what);
    }
    /// Of a GPU that failed. What is wrong with the scene or the settings is wrong for soft, too.
    void give_up(const Error& error, const std::string& source, Context& context) {
        context.throw_if_cancelled();
        if (error.code() != ErrorCode::failed) throw;
        say("it continues with engine soft: " + error.reason(), Remark::warning, source, context);
        gpu_ = nullptr;
        draws_on_gpu_ = false;
    }

    std::unique_ptr<Engine> gpu_, soft_;
    std::shared_ptr<const geometry::MeshPoses> poses_;  ///< of the scene that was prepared last
    std::string why_;                                   ///< there is no `gpu_`
    bool draws_on_gpu_ = false, is_said_ = false;
};

}  // namespace

std::unique_ptr<Engine> make_auto_engine() {
    std::string why = "OpenGL is not built in";
    std::unique_ptr<Engine> gpu;
#ifdef RL_HAVE_OPENGL
    gpu = opengl::make_gpu_engine(why);
#endif
    return make_auto_engine(std::move(gpu), std::move(why));
}

std::unique_ptr<Engine> make_auto_engine(std::unique_ptr<Engine> gpu, std::string why) {
    return std::make_unique<AutoEngine>(std::move(gpu), std::move(why));
}

}  // namespace rakelight
