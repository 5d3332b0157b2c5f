// SPDX-License-Identifier: Apache-2.0
// Draws over a finished picture (docs/overlays.md), row by row, for any engine: the same in windows and strips as in
// the whole picture.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <rakelight/render/picture.h>

#include "render/output/ground_grid.h"
#include "render/rows.h"

namespace rakelight {

class Overlay {
public:
    /// @param scene   as the engine has it
    /// @param camera  in the world
    /// @param shown  all that a sequence shows, which the grid lies below; empty: the scene
    Overlay(const PictureRequest& request, const Scene& scene, const Camera& camera, const Bounds& shown = {});

    bool is_empty() const { return !grid_ && sprites_.empty(); }
    bool needs_depth() const { return grid_.has_value(); }
    void draw(const PictureRows& rows, Context& context) const;

private:
    /// A small picture, RGBA, with its place in the whole.
    struct Sprite {
        int x, y;
        Pixels pixels;
    };
    void add_axes(const Camera& camera);
    enum class Corner { top, bottom_right };
    void add_words(const std::string& text, Corner corner);

    int width_, height_;  ///< [px] of the whole picture
    std::optional<GroundGrid> grid_;
    std::vector<Sprite> sprites_;
};

/// The lines of --metadata.
std::string metadata_text(const std::string& file, const Scene& scene);

}  // namespace rakelight
