// SPDX-License-Identifier: Apache-2.0
// What the library shows to those who link it. Its objects are compiled with hidden visibility; only declarations with RL_API
// are seen from outside a shared library. Templates and inline functions need none.
#pragma once

#if defined(__GNUC__)
#define RL_API __attribute__((visibility("default")))
#else
#define RL_API
#endif
