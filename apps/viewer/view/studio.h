// SPDX-License-Identifier: Apache-2.0
// A session with a model in it, as a look wants it: only what changed is recomputed.
#pragma once
#include <memory>
#include <optional>

#include <rakelight/render/session.h>

#include "../document/document.h"

namespace rakelight::viewer {

class Studio {
public:
    /// The shot of a picture as render_picture() draws it. The session shows its scene then.
    /// @param request  of request_of(look), at the size to be drawn
    Shot plan(const std::shared_ptr<const Model>& model, const Look& look, const PictureRequest& request,
              const Camera& camera, Context& context);
    /// Prepares the scene of the shot, for others to draw.
    void prepare(const Shot& shot, Context& context);
    /// @param wished  Channel bits that are given, too, where the engine has them
    RenderStats draw(Shot shot, std::uint32_t wished, Sink& sink, Context& context);

    /// The scene that was drawn or prepared last.
    const std::shared_ptr<const PreparedScene>& prepared() const { return prepared_; }

private:
    std::optional<Session> session_;
    std::string engine_;
    PrepareOptions prepare_;
    std::shared_ptr<const Model> model_;
    std::vector<MaterialEdit> edits_;
    std::shared_ptr<const Scene> edited_;  ///< the model's scene with these
    std::shared_ptr<const PreparedScene> prepared_;
};

}  // namespace rakelight::viewer
