// SPDX-License-Identifier: Apache-2.0
// Paths as the window shows them: short, and without the folders of the machine where the name says enough.
#pragma once
#include <string>

namespace rakelight::viewer {

/// From the working folder where the file lies in it, from "~" where it lies in the home folder; else as it is named.
std::string short_path(const std::string& file);
/// As short_path(), but the file's name alone where its path would still begin at the root.
std::string display_path(const std::string& file);
/// A text with paths in it: those in the model's folder are shortened to start there.
std::string with_short_paths(std::string text, const std::string& model_file = {});

}  // namespace rakelight::viewer
