// SPDX-License-Identifier: Apache-2.0
#include "gl_painters.h"

namespace rakelight::viewer {
namespace {

constexpr int most_faults = 2;  // that a new context is made after

}  // namespace

bool GlPainters::draws(const Look& look, bool has_gpu) const {
    const std::string& engine = look.request.engine;
    const bool is_wanted = engine == "gl" || (engine == "auto" && has_gpu);
    return is_wanted && !has_failed_ && look.channel == 0;
}

std::shared_ptr<GlPainter> GlPainters::get(std::size_t picture) {
    std::shared_ptr<GlPainter>& painter = painters_[picture];
    if (!painter) painter = std::make_shared<GlPainter>(make_context_());
    return painter;
}

bool GlPainters::restart() {
    if (faults_++ >= most_faults) {
        has_failed_ = true;
        return false;
    }
    for (std::shared_ptr<GlPainter>& painter : painters_)
        if (painter) lost_.push_back(std::move(painter));
    return true;
}

}  // namespace rakelight::viewer
