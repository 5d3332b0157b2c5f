// SPDX-License-Identifier: Apache-2.0
// A setting of pictures as the text of one field, by its key of [render].
#pragma once
#include <string>

#include "document.h"

namespace rakelight::viewer {

/// The current value of the setting; words of a list as shells write them. Empty: its default.
std::string setting_text(const PictureRequest& request, const std::string& key);

/// Sets it as if the file had said so; an empty text sets its default. The engine and the method are chosen as by choose_engine()
/// and choose_method(). @throws Error usage; then nothing is changed
void set_setting(Look& look, const std::string& key, const std::string& text);

}  // namespace rakelight::viewer
