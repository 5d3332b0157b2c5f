// SPDX-License-Identifier: Apache-2.0
// Draws scenes by OpenGL, or frames of any engine, in the caller's OpenGL context. This header uses no OpenGL type.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <rakelight/export.h>
#include <rakelight/line.h>
#include <rakelight/session.h>

namespace rakelight {

/// Draws 8-bit sRGB codes into the bound framebuffer, at the current viewport, whatever GL_FRAMEBUFFER_SRGB is. Other
/// OpenGL state is not preserved. All calls, and the destructor, run on the thread where the context is current. OpenGL
/// 3.3 core or ES 3.0.
/// @throws Error failed: the context is too old or lost (create a new one, and a new view), or out of GPU memory
class RL_API GlView {
public:
    GlView();
    ~GlView();
    GlView(const GlView&) = delete;
    GlView& operator=(const GlView&) = delete;

    std::string renderer() const;  ///< GL_RENDERER
    bool has_gpu() const;  ///< false: a software rasterizer such as llvmpipe draws; the engine soft is faster then

    /// Uploads a scene, for at most this time per call. Until it is complete, draw() draws the previous one.
    /// @return true: it is complete
    bool upload(std::shared_ptr<const PreparedScene> scene, double milliseconds, Context& context);
    /// Draws the last completely uploaded scene, as Session::render() does with the engine gl; nothing if there is
    /// none.
    RenderStats draw(const Camera& camera, const RenderSettings& settings, const ToneSettings& tone, Context& context);
    /// Shows a picture over the whole viewport, row 0 on top.
    /// @param srgb8 [width * height] sRGB codes, R in the low
    /// byte, straight alpha, over black
    /// @param smooth filtered where the viewport has another size
    void show(int width, int height, std::span<const std::uint32_t> srgb8, bool smooth = true);
    /// The same for a frame of linear colors.
    /// @param behind as in to_srgb8(): the result of separate_background()
    void show(const Frame& frame, const ToneSettings& tone = {}, vec4 behind = {});
    /// Shows the picture of the last show() again, without an upload: for windows that are redrawn while their picture
    /// stays.
    /// @return false: there is no picture, and nothing was drawn
    bool show_again();
    /// Draws lines over the picture. Surfaces of the last draw() hide lines that are not overlays; after show() nothing
    /// hides them.
    void lines(const Camera& camera, std::span<const Line> lines);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rakelight
