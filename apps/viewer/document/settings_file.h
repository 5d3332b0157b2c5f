// SPDX-License-Identifier: Apache-2.0
// What the viewer remembers from run to run: $XDG_CONFIG_HOME/rakelight/view.conf, else ~/.config/rakelight/view.conf.
#pragma once
#include <string>
#include <vector>

#include "own_keys.h"
#include "ui_state.h"

namespace rakelight::viewer {

struct Remembered {
    UiState ui;
    std::vector<OwnKey> own_keys;
    std::vector<std::string> wrong_lines;  ///< "line 3: dark = maybe": that are not understood
    int width = 1280, height = 800;        ///< [px] of the window
};

/// Empty: no such folder can be named.
std::string settings_path();
/// Lines "key = value", and of the user's own "key Ctrl+K = S"; what is not understood is left out.
Remembered parse_settings(const std::string& text);
/// @param before  as the file is: lines of the user's own stay as they are
std::string settings_text(const Remembered& remembered, const std::string& before = {});
Remembered read_settings();
/// Which lines of the file are wrong, for people.
std::string wrong_lines_text(const Remembered& remembered);
/// Says nothing where it cannot be written: the viewer works without. A file that cannot be read is left alone.
void write_settings(const Remembered& remembered) noexcept;

}  // namespace rakelight::viewer
