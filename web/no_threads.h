// SPDX-License-Identifier: Apache-2.0
// Included before every source of the web build. A thread that is started there throws when it runs; so it does not compile.
#pragma once
#if defined(__cplusplus)
#include <future>
#include <thread>
#pragma GCC poison async thread jthread pthread_create
#endif
