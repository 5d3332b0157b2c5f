// SPDX-License-Identifier: Apache-2.0
// Whether OpenGL draws a picture, by which painter, and what follows if it fails: it is started again some times, then given up.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../document/document.h"
#include "gl_painter.h"

namespace rakelight::viewer {

/// One GlPainter per picture of the window, made when it is needed. In the window's thread.
class GlPainters {
public:
    using MakeContext = std::function<std::unique_ptr<SharedContext>()>;
    explicit GlPainters(MakeContext make_context) : make_context_(std::move(make_context)) {}

    /// @param has_gpu  GlView::has_gpu(): the engine auto is gl then
    bool draws(const Look& look, bool has_gpu) const;
    /// The one of a picture. @throws Error failed: there is no context
    std::shared_ptr<GlPainter> get(std::size_t picture);
    bool has(std::size_t picture) const { return bool(painters_[picture]); }
    /// After a fault. @return true: get() makes new ones; false: OpenGL draws no more
    bool restart();

private:
    MakeContext make_context_;
    std::vector<std::shared_ptr<GlPainter>> lost_;  ///< threads may hold them still; they end in the window's thread
    std::shared_ptr<GlPainter> painters_[2];
    int faults_ = 0;
    bool has_failed_ = false;
};

}  // namespace rakelight::viewer
