// SPDX-License-Identifier: Apache-2.0
// The ways on which a picture is drawn. Each keeps what it has made for the pictures before.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/render/session.h>
#include <rakelight/world/request.h>

#include "../../apps/viewer/document/document.h"
#include "../../apps/viewer/view/painter.h"

namespace rakelight::test {

/// sRGB codes, R in the low byte, and the size.
struct Shown {
    int width = 0, height = 0;
    std::vector<std::uint32_t> codes;
    bool operator==(const Shown&) const = default;
};

// @param time_s  absent: at rest, without a clip

/// render_picture(), each by itself.
Shown by_picture(const PictureRequest& request, std::optional<double> time_s, Context& context);

/// render_sequence(): a picture for each moment of the clip, which are step_s apart. @param folder  for its files
std::vector<Shown> by_sequence(PictureRequest request, double step_s, std::size_t count, const std::string& folder,
                               Context& context);

/// Sessions, one for each engine, which have drawn all pictures before; all of one model. A request is decided at its first
/// picture.
class BySession {
public:
    Shown draw(const PictureRequest& asked, std::optional<double> time_s, Context& context);

private:
    std::shared_ptr<const Scene> loaded_;
    std::map<std::string, Session> sessions_;
    std::optional<PictureRequest> asked_, decided_;  ///< the last one
};

/// The viewer at rest; all looks are of one document.
class ByViewer {
public:
    ByViewer(const std::string& file, Context& context);
    Shown draw(const PictureRequest& request, std::optional<double> time_s);

private:
    std::shared_ptr<const viewer::Model> model_;
    std::uint64_t number_ = 0;
    viewer::Painter painter_{[] {}, 2, 0};
};

}  // namespace rakelight::test
