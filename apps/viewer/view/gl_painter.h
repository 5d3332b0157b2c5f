// SPDX-License-Identifier: Apache-2.0
// Pictures by GlView in the painter's thread: the scene is taken up piece by piece, programs are made before they are timed,
// lines are hidden by the very depth of the picture.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <rakelight/render/gl_view.h>

#include "gl_pictures.h"
#include "shared_context.h"

namespace rakelight::viewer {

/// Made in the window's thread, used in one other; ends in the window's thread, after end() in the other.
/// @throws Error as GlView; failed: OpenGL does not continue, then neither does this
class GlPainter {
public:
    explicit GlPainter(std::unique_ptr<SharedContext> context) : context_(std::move(context)) {}
    void end();

    /// Takes a scene up for so long; until it is whole, draw() draws the one before. @return true: it is whole
    bool upload(const std::shared_ptr<const PreparedScene>& scene, double milliseconds, Context& context);
    /// The scene that draw() draws; null: none yet.
    const std::shared_ptr<const PreparedScene>& scene() const { return scene_; }

    struct Drawn {
        std::shared_ptr<GlPicture> picture;
        RenderStats stats;
        double ms = 0;  ///< without what is made once: programs, shadow maps
    };
    Drawn draw(const Shot& shot, const ToneSettings& tone, std::span<const Line> lines, Context& context);

private:
    /// The settings that programs depend on.
    struct Warmed {
        RenderSettings settings;
        ToneMapping tone;
        bool operator==(const Warmed&) const = default;
    };
    void begin();
    void warm(const Shot& shot, const ToneSettings& tone, Context& context);

    std::unique_ptr<SharedContext> context_;
    bool is_current_ = false;
    std::optional<GlView> view_;
    std::optional<GlPicturePool> pictures_;
    std::shared_ptr<const PreparedScene> scene_;
    std::vector<Warmed> warmed_;  ///< of this scene
};

}  // namespace rakelight::viewer
