// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <csignal>

#include <atomic>

namespace rakelight::cli {
namespace {

std::atomic<Context*> running{nullptr};
std::atomic<bool> interrupted{false};
static_assert(std::atomic<Context*>::is_always_lock_free, "a signal handler may use it");

void cancel_running(int signal) {
    interrupted = true;
    if (Context* context = running.load()) context->cancel();
    std::signal(signal, SIG_DFL);
}

}  // namespace

CancelOnInterrupt::CancelOnInterrupt(Context& context) {
    running = &context;
    for (const int signal : {SIGINT, SIGTERM})
        if (std::signal(signal, cancel_running) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup wants it
}

CancelOnInterrupt::~CancelOnInterrupt() {
    running = nullptr;
    for (const int signal : {SIGINT, SIGTERM})
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool CancelOnInterrupt::happened() { return interrupted; }

}  // namespace rakelight::cli
