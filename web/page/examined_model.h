// SPDX-License-Identifier: Apache-2.0
// A model with what was found at its borders: all that the page knows of a file.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include <rakelight/engines/line.h>
#include <rakelight/tools/inspect.h>

#include "../../apps/viewer/document/document.h"

namespace rakelight::web {

struct ExaminedModel {
    std::shared_ptr<const viewer::Model> model;
    Inspection inspection;
    std::vector<SeamLine> seams;  ///< the worst
    std::vector<Line> heat_map;   ///< the same in their colors
};

/// @param settings  keys of [render]: how creases and missing normals are found
/// @throws Error as inspect()
std::shared_ptr<const ExaminedModel> examine(std::shared_ptr<const viewer::Model> model,
                                             std::span<const WorldValue> settings, Context& context);
/// @throws Error as load() and inspect()
std::shared_ptr<const ExaminedModel> examine(const std::string& file, std::span<const WorldValue> settings,
                                             Context& context);

/// How the normals are made of which inspect() measures the seams: those of the file, or one object at a time.
PrepareOptions as_measured(const Scene& scene, PrepareOptions options);

}  // namespace rakelight::web
