// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/current_error.h>

#include <new>
#include <stdexcept>
#include <system_error>
#include <typeinfo>

using namespace rakelight;

namespace {
template <class Exception>
Error said_of(const Exception& exception) {
    try {
        throw exception;
    } catch (...) {
        return current_error();
    }
}
}  // namespace

TEST(CurrentError, IsTheErrorItself) {
    const Error e = said_of(Error(ErrorCode::bad_file, "broken", "line 3", "repair it").with_file("a.obj"));
    EXPECT_EQ(e.code(), ErrorCode::bad_file);
    EXPECT_STREQ(e.what(), "a.obj: line 3: broken; repair it");
}

TEST(CurrentError, SaysExceptionsOfTheStandardLibraryInItsOwnWords) {
    for (const Error& e : {said_of(std::bad_alloc()), said_of(std::bad_array_new_length()),
                           said_of(std::length_error("vector::reserve"))}) {
        EXPECT_EQ(e.code(), ErrorCode::failed);
        EXPECT_STREQ(e.what(), "out of memory");
    }
    const std::string internal = "an internal error stopped the work; please report it with the file";
    EXPECT_EQ(said_of(std::out_of_range("basic_string_view::substr: __pos (which is 201)")).what(), internal);
    EXPECT_EQ(said_of(std::bad_cast()).what(), internal);
    EXPECT_EQ(said_of(1).what(), internal) << "no exception class at all";
    const auto full = std::make_error_code(std::errc::no_space_on_device);
    EXPECT_EQ(said_of(std::system_error(full, "std::thread")).what(), "unexpected: " + full.message());
    EXPECT_STREQ(said_of(std::runtime_error("said by a library")).what(), "unexpected: said by a library");
}

TEST(CurrentError, TakesTheWordsForALackOfMemory) {
    try {
        throw std::bad_alloc();
    } catch (...) {
        EXPECT_STREQ(current_error("more than the limit of 3 MiB").what(), "more than the limit of 3 MiB");
    }
}
