// SPDX-License-Identifier: Apache-2.0
// from_chars() of float and double: of the standard library, or of fast_float where it has none (libc++ before 20).
// Out of range, the value is infinite or next to 0.
#pragma once
#include <charconv>

#if !defined(__cpp_lib_to_chars)
#include <fast_float/fast_float.h>
#endif

namespace rakelight {

#if defined(__cpp_lib_to_chars)
using std::from_chars;
#else
template <class Real>
std::from_chars_result from_chars(const char* first, const char* last, Real& value) {
    const fast_float::from_chars_result result = fast_float::from_chars(first, last, value);
    return {result.ptr, result.ec};
}
#endif

}  // namespace rakelight
