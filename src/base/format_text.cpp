// SPDX-License-Identifier: Apache-2.0
// The only source with code of fmt, as hidden symbols: programs that link Rakelight do not need fmt, and it is compiled
// once.
#define FMT_HEADER_ONLY 1
#define FMT_STATIC_THOUSANDS_SEPARATOR ','  // no pattern uses it; else it would be asked of the locale, with all its code
#include "base/format_text.h"

#include <fmt/format.h>

namespace rakelight {

std::string format_arguments(fmt::string_view pattern, fmt::format_args arguments) {
    return fmt::vformat(pattern, arguments);
}

}  // namespace rakelight
