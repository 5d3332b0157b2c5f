// SPDX-License-Identifier: Apache-2.0
// Draws scenes by OpenGL, or frames of any engine, in the caller's OpenGL context. This header uses no OpenGL type.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <rakelight/base/export.h>
#include <rakelight/engines/line.h>
#include <rakelight/render/session.h>

namespace rakelight {

/// Draws 8-bit sRGB codes into the bound framebuffer, at the current viewport. The value of GL_FRAMEBUFFER_SRGB has no
/// effect. OpenGL state is not preserved. Make all calls, and destroy the view, on the thread where the context is
/// current. Needs OpenGL 3.3 core or ES 3.0.
/// @throws Error failed: the context is too old, out of GPU memory, or lost. After a lost context create a new context
///         and a new view.
class RL_API GlView {
public:
    GlView();
    ~GlView();
    GlView(const GlView&) = delete;
    GlView& operator=(const GlView&) = delete;

    std::string renderer() const;  ///< GL_RENDERER
    bool has_gpu() const;  ///< false: a software rasterizer such as llvmpipe draws, and the engine soft is faster

    /// Uploads a scene, for at most this time per call. Until the upload is complete, draw() draws the previous scene.
    /// @return true: the upload is complete
    bool upload(std::shared_ptr<const PreparedScene> scene, double milliseconds, Context& context);
    /// Draws the last completely uploaded scene, as Session::render() does with the engine gl. Draws nothing if no
    /// upload is complete.
    /// @param shot  of plan_shot() if there is an exposure or a tone curve: they apply to a background that is not separate
    RenderStats draw(const Shot& shot, const ToneSettings& tone, Context& context);
    /// Shows a picture over the whole viewport, row 0 on top.
    /// @param srgb8 [width * height] sRGB codes, R in the low byte, straight alpha. Composited over black
    /// @param smooth true: filter the picture if the viewport has another size
    void show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth = true);
    /// The same for a frame of linear colors.
    /// @param behind as in to_srgb8(): Shot::behind
    void show(const Frame& frame, const ToneSettings& tone = {}, vec4 behind = {});
    /// Shows the picture of the last show() again, without an upload. Use it to redraw a window with an unchanged
    /// picture.
    /// @return false: nothing was drawn, because there is no picture
    bool show_again();
    /// Draws lines over the picture. After draw(), surfaces hide the lines behind them, except overlays
    /// (Line::is_overlay). After show(), all lines are visible.
    void lines(const Camera& camera, std::span<const Line> lines);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight
