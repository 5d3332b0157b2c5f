// SPDX-License-Identifier: Apache-2.0
// Shows pictures in the window, one or two, with the lines over them.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <rakelight/render/gl_view.h>

#include "../view/pictures.h"
#include "window.h"

namespace rakelight::viewer {

class Screen {
public:
    /// Ends before the window. @throws Error failed: OpenGL is too old
    explicit Screen(GlfwWindow& window);

    bool has_gpu() const { return canvases_[0].gl->has_gpu(); }           ///< GlView::has_gpu()
    std::string renderer() const { return canvases_[0].gl->renderer(); }  ///< likewise

    /// Between GlfwWindow::begin_panels() and end_panels(). @param marks  of each picture
    void draw(const Pictures& pictures, const UiState& ui, std::span<const Marks> marks);

private:
    /// Shows a picture that is not on the GPU.
    struct Canvas {
        std::unique_ptr<GlView> gl;             ///< null: not needed yet
        std::shared_ptr<const Painting> shown;  ///< that `gl` holds
        MarkLines lines;
    };
    /// The picture that is shown of two over each other.
    struct Wipe {
        std::shared_ptr<const Painting> a, b;
        int line = 0, width = 0, height = 0;
        bool operator==(const Wipe&) const = default;
    };
    void draw_picture(const Pictures& pictures, std::size_t i, const Marks& marks);
    void show_codes(const PictureView& view, Canvas& canvas);
    void draw_wipe(const Pictures& pictures, double share, std::span<const Marks> marks);
    void draw_wipe_on_gpu(const Pictures& pictures, int line, std::span<const Marks> marks);
    void draw_wipe_of_codes(const Wipe& wanted, const PixelBox& area);
    void draw_lines(const Pictures& pictures, std::size_t i, const Marks& marks);
    void draw_split(const Pictures& pictures, const UiState& ui);

    GlfwWindow& window_;
    Canvas canvases_[2];
    Wipe wipe_;
    std::vector<std::uint32_t> wiped_;  ///< its pixels
};

}  // namespace rakelight::viewer
