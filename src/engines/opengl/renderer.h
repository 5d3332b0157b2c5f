// SPDX-License-Identifier: Apache-2.0
// A scene on the GPU, and the passes that draw it. On one thread, whose context is current; the engine and the view of a
// window share it.
#pragma once
#include <array>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <rakelight/engines/engine.h>

#include "engines/opengl/context/pass_meter.h"
#include "engines/opengl/picture/behind.h"
#include "engines/opengl/picture/blended.h"
#include "engines/opengl/picture/channels.h"
#include "engines/opengl/picture/covered.h"
#include "engines/opengl/picture/marks.h"
#include "engines/opengl/picture/picture.h"
#include "engines/opengl/picture/target.h"
#include "engines/opengl/scene/scene_upload.h"
#include "shading/lights/shadow_cameras.h"

namespace rakelight::opengl {

class Renderer {
public:
    Renderer();  ///< @throws Error failed: see ask_driver()

    const Driver& driver() const { return driver_; }
    /// As Engine::prepare().
    void prepare(GivenScene given, Context& context);
    /// The same in steps: take_scene() with what decoded() gives, on any thread; upload() as often as it takes, while the scene
    /// before is drawn; then take().
    shading::TextureCache decoded() const { return cache_; }
    shading::EnvironmentCache decoded_environment() const { return environments_; }
    bool upload(const TakenScene& scene, Clock::time_point end, Context& context) {
        return upload_some(scene, textures_, meshes_, end, context);
    }
    void take(TakenScene scene, Context& context);
    void forget_uploads();  ///< of a scene that is not taken
    /// Meshes that are posed on the GPU are in bind pose.
    const Scene& scene() const { return list_.scene; }
    PoseStore& poses() { return poses_; }
    std::uint64_t mesh_bytes() const { return meshes_.bytes() + poses_.bytes(); }  ///< of buffers on the GPU
    std::uint32_t channels() const { return settings_.channels; }                  ///< of the picture that is drawn
    void set_lights(std::vector<Light> lights);

    /// What stays the same for all parts of a picture. After prepare() and set_lights().
    void begin_picture(const Camera& camera, const RenderSettings& settings, RenderStats& stats, Context& context);
    /// Colors of a part of it, as large as the target, which is resolved then.
    void draw_part(Window pixels, Target& to, Context& context);
    /// The same into a target of its own.
    void draw_part(Window pixels, Context& context) {
        target_.reserve(pixels.width, pixels.height, settings_.samples);
        draw_part(pixels, target_, context);
    }
    /// From there. @param to  [pixels of the part] straight alpha
    void read_part(std::span<vec4> to);
    /// Counts and times of all parts; what is to be said of them.
    void end_picture(RenderStats& stats, Context& context);
    /// A warning where blended triangles of the part that was drawn last, or of an earlier picture of the scene, are in the
    /// wrong order.
    void remark_order(Report& report);
    /// Data channels of a part of the picture, which are filled. After its colors.
    void draw_channels(Window pixels, ChannelArrays& to, Context& context);
    /// What the lighting text of the picture declares as terms, light by light, at a pixel. After its colors.
    std::vector<std::array<vec4, 4>> user_terms(int x, int y, Context& context);
    shading::PictureCamera picture_camera_of(const Camera& camera, const RenderSettings& settings) const {
        return shading::picture_camera_of(list_, camera, settings);
    }
    float far_depth() const { return DepthRange(driver_).far_depth(); }

private:
    struct KeptMaps {
        std::size_t light;
        std::vector<shading::MapCamera> cameras;
        shading::PictureCamera view;
        ShadowAtlas::Place place;
    };
    PictureState picture_state();
    void forget_picture();
    void keep_meshes(const Scene& scene, const geometry::MeshPoses& poses);
    void pose_meshes(Context& context);
    void pose_measured_meshes(Context& context);
    void pose_here(std::uint32_t mesh, Context& context);
    std::set<std::uint32_t> meshes_read_by_processor();
    void update_shadows(const RenderSettings& settings, dvec3 eye, std::vector<lighting::LightParameters>& lights,
                        RenderStats& stats, Context& context);
    std::vector<KeptMaps> draw_shadow_maps(const RenderSettings& settings, Context& context);
    void draw_shadow_map(const shading::PictureCamera& view, const RenderSettings& settings, ShadowAtlas::Place place,
                         int face, Context& context);
    void draw_behind(Context& context);
    void make_albedos();
    void note_dropped(std::uint32_t draw, const DrawState& state);
    void remark_dropped_maps(Report& report) const;
    /// Warns of a near plane so close that this driver's depths do not tell far surfaces apart.
    void remark_depths(Report& report) const;
    /// @param blended  gets those that are left for draw_blended()
    void draw_surfaces(const PictureDrawer& drawer, const PictureState& state, std::vector<std::uint32_t>& blended,
                       Context& context);
    void draw_channel_group(const PictureDrawer& drawer, const PictureState& state, Output group, bool wants_triangles,
                            Context& context);
    void draw_blended(const PictureDrawer& drawer, const PictureState& state, const std::vector<std::uint32_t>& draws,
                      Context& context);
    void draw_colors(const PictureDrawer& drawer, const PictureState& state, Context& context);
    PictureTools tools() {
        return {driver_, programs_, meshes_, environment_, shadows_, albedos_.name(), behind_.texture(), poses_};
    }

    Driver driver_;
    Programs programs_{driver_};
    MeshStore meshes_{driver_};
    PoseStore poses_{driver_};
    TextureStore textures_{driver_};
    ShadowAtlas shadows_{driver_};
    EnvironmentStore environment_;
    shading::TextureCache cache_;
    shading::EnvironmentCache environments_;
    shading::DrawList list_;
    geometry::MeshPoses unposed_;  ///< of meshes of the list that are in bind pose
    GlTexture albedos_;
    Target target_;
    BehindPicture behind_;
    ChannelTarget channel_target_;
    Marks marks_;
    CoveredCounter counter_{driver_};
    PassMeter meter_{driver_};
    GlBuffer stream_;

    // Of the picture that is drawn.
    std::uint64_t not_finite_ = 0, covered_ = 0;
    std::vector<bool> seen_;                           ///< [draws] not outside of the picture
    std::uint32_t dropped_maps_ = 0, dropped_of_ = 0;  ///< DrawState::dropped of the first draw with any
    RenderSettings settings_;
    shading::PictureCamera view_;
    shading::BehindFactors behind_factors_{};
    bool has_behind_ = false;
    std::vector<BlendedRun> blended_;  ///< of the part that was drawn last
    std::vector<Shading> shading_;
    std::vector<lighting::LightParameters> light_parameters_;
    std::vector<LightShadow> light_shadows_;
    LightTable lights_;

    // Shadow maps that exist: of the list, for these settings.
    std::vector<KeptMaps> maps_;
    int map_size_ = 0, map_filter_ = 0;
    bool order_is_wrong_ = false;  ///< in some picture of the list, so that the next ones need not be looked at
};

}  // namespace rakelight::opengl
