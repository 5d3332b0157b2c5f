// SPDX-License-Identifier: Apache-2.0
#include "stack.h"

#include <pthread.h>
#include <sys/resource.h>

#include <algorithm>

#if RL_THREADS
namespace rakelight::apps {
namespace {

constexpr rlim_t enough_bytes = rlim_t(8) << 20;  // what Linux gives by default

struct Task {
    const std::function<int()>& work;
    int code = 0;
};

void* run(void* task) {
    auto& t = *static_cast<Task*>(task);
    t.code = t.work();
    return nullptr;
}

/// Of programs that are started: their limit may be raised up to the hard one.
void raise_limit(rlimit limit) {
    limit.rlim_cur = std::min(enough_bytes, limit.rlim_max);
    setrlimit(RLIMIT_STACK, &limit);
}

}  // namespace

int with_enough_stack(const std::function<int()>& work) {
    rlimit limit{};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= enough_bytes) return work();
    raise_limit(limit);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, enough_bytes);
#ifdef __GLIBC__
    pthread_setattr_default_np(&attributes);  // else it is what the limit was when the process began
#endif
    Task task{work};
    pthread_t thread{};
    const bool is_started = pthread_create(&thread, &attributes, run, &task) == 0;
    pthread_attr_destroy(&attributes);
    if (!is_started) return work();
    pthread_join(thread, nullptr);
    return task.code;
}

}  // namespace rakelight::apps
#else
int rakelight::apps::with_enough_stack(const std::function<int()>& work) { return work(); }
#endif
