// SPDX-License-Identifier: Apache-2.0
// The scenes that a session draws during a sequence: from picture to picture only what moves is recomputed.
#pragma once
#include <memory>

#include <rakelight/picture.h>
#include <rakelight/session.h>

#include "render/prepared_scene.h"

namespace rakelight {

class SequenceScenes {
public:
    explicit SequenceScenes(Session& session) : session_(session) {}

    /// The session draws this scene from now on. @param scene  passed validate(), with the lights of the picture
    void show(Scene scene, const PrepareOptions& options, const RenderSettings& settings, Context& context);
    /// As it is drawn, except for vertices, which may be in bind pose. show() was called before.
    const Scene& current() const { return ready_->scene; }
    const Scene& posed(Context& context) const { return ready_->posed(context); }

private:
    Session& session_;
    Scene known_;                           ///< that was shown last, before it was prepared
    std::shared_ptr<PreparedScene> ready_;  ///< of it; null: none was
};

}  // namespace rakelight
