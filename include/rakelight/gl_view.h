// SPDX-License-Identifier: Apache-2.0
// Pictures in a window: scenes drawn by OpenGL, or frames of any engine shown, in a context of the caller's. No type of
// OpenGL is named here.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <rakelight/export.h>
#include <rakelight/line.h>
#include <rakelight/session.h>

namespace rakelight {

/// Draws into the framebuffer that is bound, at the viewport that is set: 8-bit sRGB codes, whatever GL_FRAMEBUFFER_SRGB
/// says; what else OpenGL is set to is not kept. All calls on the thread of the context, which must be current; ends
/// there, too. OpenGL 3.3 core or ES 3.0.
/// @throws Error failed: too old a context, no memory on the GPU, a context that is lost: then its owner makes a new one,
/// and a new view
class RL_API GlView {
public:
    GlView();
    ~GlView();
    GlView(const GlView&) = delete;
    GlView& operator=(const GlView&) = delete;

    std::string renderer() const;  ///< what draws, as GL_RENDERER says
    bool has_gpu() const;          ///< false: llvmpipe or the like draws; frames of the engine soft come faster then

    /// Takes a scene up, for so long at a time; until it is whole, draw() draws the one before.
    /// @return true: it is whole
    bool upload(std::shared_ptr<const PreparedScene> scene, double milliseconds, Context& context);
    /// Draws the scene that is whole, as Session::render() does with the engine gl; nothing where there is none.
    RenderStats draw(const Camera& camera, const RenderSettings& settings, const ToneSettings& tone, Context& context);
    /// Shows a picture of codes, row 0 on top, over the whole viewport. @param srgb8  [width * height] R in the low byte,
    /// straight alpha, over black. `smooth`: filtered where the viewport has another size
    void show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth = true);
    /// The same of a frame of linear colors. @param behind  as to_srgb8() takes it: of keep_background()
    void show(const Frame& frame, const ToneSettings& tone = {}, vec4 behind = {});
    /// Shows the picture of the last show() once more, as it was to be filtered then; nothing is uploaded. For windows
    /// that are drawn again while their picture stays. @return false: there is none, and nothing was drawn
    bool show_again();
    /// Lines over what was drawn or shown. Those that are no overlay are hidden by the surfaces of the last draw(); after
    /// show() nothing hides them.
    void lines(const Camera& camera, std::span<const Line> lines);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight
