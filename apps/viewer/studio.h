// SPDX-License-Identifier: Apache-2.0
// A session with a model in it, as a look wants it: only what changed is recomputed.
#pragma once
#include <memory>
#include <optional>

#include <rakelight/session.h>

#include "document.h"

namespace rakelight::viewer {

class Studio {
public:
    /// Draws as render_picture() does. @param request  of request_of(look), at the size to be drawn
    /// @param wished  Channel bits that are given, too, where the engine has them
    RenderStats draw(const std::shared_ptr<const Model>& model, const Look& look, PictureRequest request,
                     const Camera& camera, std::uint32_t wished, Sink& sink, Context& context);

    /// The scene that such a picture is drawn of, for others to draw; nothing is drawn.
    const std::shared_ptr<const PreparedScene>& prepare(const std::shared_ptr<const Model>& model, const Look& look,
                                                        const PictureRequest& request, const Camera& camera,
                                                        Context& context);

    /// What was drawn or prepared last.
    const std::shared_ptr<const PreparedScene>& prepared() const { return prepared_; }

private:
    /// Whether nothing but lights, camera and moment changed.
    bool is_taken_up(const std::shared_ptr<const Model>& model, const Look& look, const PictureRequest& request) const;
    void warm_up(const std::shared_ptr<const Model>& model, const Look& look, const PictureRequest& request,
                 const Camera& camera, Context& context);

    std::optional<Session> session_;
    std::string engine_;
    std::shared_ptr<const Model> model_;
    std::optional<Look> look_;  ///< whose surfaces are in scene_
    Scene scene_;               ///< at rest, with edited and asked-for surfaces
    /// Where clips move materials before the request changes them: the moment that scene_ is at, else empty.
    std::vector<ClipTime> surface_clips_;
    PrepareOptions prepare_;
    std::vector<Light> lights_;  ///< that the session has
    std::vector<ClipTime> clips_;
    Fog fog_;
    std::shared_ptr<const PreparedScene> prepared_;
    bool is_set_ = false;  ///< the session has scene_ with these
};

}  // namespace rakelight::viewer
