// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gtest/gtest.h>
#include <rakelight/base/error.h>

namespace rakelight::test {

/// What a call throws; a failure of the test where it throws nothing.
template <class Call>
Error error_of(Call call) {
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "nothing was thrown";
    return Error(ErrorCode::failed, "nothing was thrown");
}

}  // namespace rakelight::test
