// SPDX-License-Identifier: Apache-2.0
// A file becomes a model. Runs in the background.
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "../document/document.h"

namespace rakelight::viewer {

/// The settings of the command line, which apply to every file.
struct Start {
    std::vector<std::string> files;
    std::vector<WorldValue> settings;
    LoadOptions load;
    std::function<bool(std::string_view)> takes;  ///< RenderOverrides::accepts
    int threads = 0;
    std::uint64_t max_memory = 0;
    bool wants_stats = false;
    const Context* everything = nullptr;  ///< cancelled with it; may be null
};

/// @throws Error not_found, bad_file, usage; failed: cancelled
std::shared_ptr<const Model> load_model(const std::string& file, const Start& start, Context& context);

}  // namespace rakelight::viewer
