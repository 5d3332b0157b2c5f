// SPDX-License-Identifier: Apache-2.0
// A turntable as PNG files.
#pragma once
#include <memory>
#include <string>

#include "../document/document.h"

namespace rakelight::viewer {

/// The look with its camera turned about the model, to the right; lights that follow the camera go with it.
Look turned(const Look& look, const Model& model, int width, int height, double angle_rad);

/// The result of a recording.
struct Turn {
    int written = 0, count = 0;  ///< pictures; fewer where it was cancelled
};

/// Writes FOLDER/0001.png and so on, once around. Where the context is cancelled it ends early, and what is written stays.
/// @param count  pictures @param folder  is made; an empty one is not left behind
/// @throws Error as render_picture()
Turn record_turn(const std::shared_ptr<const Model>& model, const Look& look, int width, int height, int count,
                 const std::string& folder, Context& context);

/// "wrote 72 pictures to FOLDER", "cancelled: 51 of 72 pictures are in FOLDER"
std::string to_text(const Turn& turn, const std::string& folder);

}  // namespace rakelight::viewer
