// SPDX-License-Identifier: Apache-2.0
// RL_ASSERT(condition, "text"): a broken internal contract stops the program; on in debug, sanitizer and test builds.
#pragma once
#include <cstdio>
#include <cstdlib>

#if defined(RL_ASSERTIONS)
#define RL_ASSERT(condition, text)                                                                           \
    do {                                                                                                     \
        if (!(condition)) {                                                                                  \
            std::fprintf(stderr, "%s:%d: broken contract: %s (%s)\n", __FILE__, __LINE__, #condition, text); \
            std::abort();                                                                                    \
        }                                                                                                    \
    } while (false)
#else
#define RL_ASSERT(condition, text) \
    static_cast<void>(sizeof(bool(condition)))  // not evaluated, but what it names is used
#endif
