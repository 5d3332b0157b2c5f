// SPDX-License-Identifier: Apache-2.0
// Pictures in a window, on the context that is current: what <rakelight/render/gl_view.h> is made of.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <rakelight/engines/engine.h>
#include <rakelight/engines/line.h>

#include "geometry/pose/mesh_pose.h"

namespace rakelight::opengl {

class WindowView {
public:
    WindowView();  ///< @throws Error failed: the context is too old
    ~WindowView();

    EngineCapabilities capabilities() const;
    double aspect() const;  ///< of the viewport that is set
    std::string renderer() const;
    bool has_gpu() const;
    /// Takes a scene up for so long; until it is whole the one before is drawn. Another number: another scene.
    /// @return true: it is whole
    /// @param poses  as Engine::prepare_unposed() has them
    bool upload(const Scene& scene, const std::shared_ptr<const geometry::MeshPoses>& poses, std::uint64_t number,
                double milliseconds, Context& context);
    void set_lights(std::vector<Light> lights);

    /// As GlView has them. @param camera  of the world
    /// @param behind  linear; laid behind the picture after the tone curve
    RenderStats draw(const Camera& camera, const RenderSettings& settings, const ToneSettings& tone, vec4 behind,
                     Context& context);
    void show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth);
    bool show_again();
    void lines(const Camera& camera, std::span<const Line> lines);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight::opengl
