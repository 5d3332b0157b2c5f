// SPDX-License-Identifier: Apache-2.0
// What files that are dropped on the window are for.
#pragma once
#include <string>
#include <vector>

namespace rakelight::viewer {

/// The actions for the files of one drop.
struct DropPlan {
    std::vector<std::string> models;   ///< to be stepped through; where there are any, the files beside them are theirs
    std::string environment, picture;  ///< empty: none
    bool is_empty_folder = false;      ///< nothing but folders without models
};

/// @param is_shift_down  pictures are environments then
DropPlan plan_of_drop(const std::vector<std::string>& files, bool is_shift_down);

/// A folder's files that may be models, by name; a file alone.
std::vector<std::string> models_in(const std::string& path);

}  // namespace rakelight::viewer
