// SPDX-License-Identifier: Apache-2.0
#include "helper_limits.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>

namespace rakelight::apps {
namespace {

/// @param last  the limit that ends the process without a signal that names it
void limit(int what, rlim_t value, rlim_t last) {
    const rlimit both{value, last};
    setrlimit(__rlimit_resource_t(what),
              &both);  // a lower limit that is already there makes this fail, which is as good
}
void limit(int what, rlim_t value) { limit(what, value, value); }

}  // namespace

void limit_this_process(std::uint64_t memory_bytes, std::uint64_t seconds) {
#if !defined(__SANITIZE_ADDRESS__)  // the sanitizer's shadow alone is terabytes of address space
    limit(RLIMIT_AS, memory_bytes);
#else
    static_cast<void>(memory_bytes);
#endif
    limit(RLIMIT_CPU, seconds, seconds + 1);  // SIGXCPU says why
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NOFILE, 64);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
}

}  // namespace rakelight::apps
