// SPDX-License-Identifier: Apache-2.0
// The one source that holds code of fmt, as hidden symbols: nobody who links Rakelight needs fmt, and one compilation pays for it.
#define FMT_HEADER_ONLY 1
#include "base/format_text.h"

#include <fmt/format.h>

namespace rakelight {

std::string format_arguments(fmt::string_view pattern, fmt::format_args arguments) {
    return fmt::vformat(pattern, arguments);
}

}  // namespace rakelight
