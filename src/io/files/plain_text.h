// SPDX-License-Identifier: Apache-2.0
// Text of a file as UTF-8.
#pragma once
#include <string>
#include <string_view>

#include <rakelight/base/context.h>

namespace rakelight::io {

/// The text, converted where it begins with the byte order mark of UTF-16.
class PlainText {
public:
    /// @param path  for the note that says so. @throws Error bad_file: over the memory limit
    PlainText(std::string_view bytes, const std::string& path, Context& context);
    std::string_view view() const { return charge_.bytes() > 0 ? std::string_view(converted_) : bytes_; }

private:
    std::string_view bytes_;
    MemoryCharge charge_;  ///< of `converted_`; empty: nothing was
    std::string converted_;
};

}  // namespace rakelight::io
