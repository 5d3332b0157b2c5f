// SPDX-License-Identifier: Apache-2.0
// Pictures of the fake engine as files in a folder of the test's own.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "render/draw_shot.h"
#include "render/picture.h"
#include "render/prepared_scene.h"
#include "support/temporary_folder.h"
#include "unit/render/fake_engine.h"

namespace rakelight::test {

/// An engine in a session with an empty scene.
template <class E = FakeEngine>
Session session_of_nothing(std::unique_ptr<E> engine = std::make_unique<E>()) {
    Session session(std::move(engine));
    session.set(std::make_shared<const PreparedScene>());
    return session;
}

/// render_picture() by a session.
inline PictureResult draw_picture(PictureRequest request, Session& session, Context& context) {
    FileTarget target(request);
    return rakelight::draw_picture(session, load(request.input, request.load, context), request, target, {}, context);
}

class PictureFiles : public testing::Test {
protected:
    std::string file(const std::string& name) const { return folder_.file(name); }
    Pixels decode(const std::string& name) { return io::decode_image(*io::read_file(file(name), context_), context_); }
    /// @param result  its channel_range is what channels are shown by
    PictureResult draw(const PictureRequest& request, PictureResult result = {}) {
        FileTarget target(request);
        const ChannelRange range = result.channel_range;
        const Shot shot = plan_shot({}, request, {}, {.is_linear = target.is_linear()}, context_);
        draw_shot(session_, shot, request, target, &range, result, context_);
        return result;
    }

    TemporaryFolder folder_;
    Context context_{{.threads = 2}};
    Session session_ = session_of_nothing();
    const FakeEngine& engine_ = static_cast<const FakeEngine&>(session_.engine());
};

}  // namespace rakelight::test
