// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include <rakelight/base/error.h>

#include "math/flush_denormals.h"
#include "math/isa.h"

namespace rakelight {
namespace {

/// RAKELIGHT_ISA set for one test, put back after it.
class Environment {
public:
    explicit Environment(const char* word) {
        if (const char* before = std::getenv("RAKELIGHT_ISA")) before_ = before, was_set_ = true;
        word != nullptr ? setenv("RAKELIGHT_ISA", word, 1) : unsetenv("RAKELIGHT_ISA");
    }
    ~Environment() { was_set_ ? setenv("RAKELIGHT_ISA", before_.c_str(), 1) : unsetenv("RAKELIGHT_ISA"); }

private:
    std::string before_;
    bool was_set_ = false;
};

TEST(Isa, UnsetOrEmptyMeansTheBest) {
    for (const char* word : {static_cast<const char*>(nullptr), ""}) {
        const Environment environment(word);
        EXPECT_EQ(isa_from_environment(), best_isa());
    }
}

TEST(Isa, EveryNamedSetIsTakenOrRefusedNeverReplaced) {
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        const Environment environment(name(isa));
        if (is_available(isa)) {
            EXPECT_EQ(isa_from_environment(), isa);
        } else {
            try {
                isa_from_environment();
                ADD_FAILURE() << name(isa) << " is not there and was taken";
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::usage);
                EXPECT_NE(std::string(error.what()).find(name(isa)), std::string::npos);
            }
        }
    }
}

TEST(Isa, UnknownWordsAreUsageErrors) {
    for (const char* word : {"avx", "AVX2", "sse2 ", "native", "\x1b[31m"}) {
        const Environment environment(word);
        try {
            isa_from_environment();
            ADD_FAILURE() << word << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
            EXPECT_EQ(std::string(error.what()).find('\x1b'), std::string::npos);
        }
    }
}

TEST(Isa, ScalarIsAlwaysThereAndSse2OnEveryX86) {
    EXPECT_TRUE(is_available(Isa::scalar));
#if defined(__x86_64__)
    EXPECT_TRUE(is_available(Isa::sse2));
#else
    EXPECT_EQ(best_isa(), Isa::scalar);
#endif
    EXPECT_TRUE(is_available(best_isa()));
}

TEST(FlushDenormals, HoldsInItsScopeAndRestoresWhatWasThere) {
    volatile float tiny = 1e-38f, half = 0.5f;
    EXPECT_GT(tiny * half * half, 0.0f);
    {
        const FlushDenormals guard;
        EXPECT_EQ(tiny * half * half, 0.0f);
        { const FlushDenormals inner; }
        EXPECT_EQ(tiny * half * half, 0.0f);
    }
    EXPECT_GT(tiny * half * half, 0.0f);
}

}  // namespace
}  // namespace rakelight
