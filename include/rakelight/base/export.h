// SPDX-License-Identifier: Apache-2.0
// The macro RL_API, which exports a function or class from the shared library. All other symbols are hidden. Templates
// and inline functions do not need RL_API.
#pragma once

#if defined(__GNUC__)
#define RL_API __attribute__((visibility("default")))
#else
#define RL_API
#endif
