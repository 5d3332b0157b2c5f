// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <csignal>

#include <atomic>

namespace rakelight::cli {
namespace {

std::atomic<Context*> running{nullptr};
std::atomic<int> interrupted{0};  // the signal
constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
static_assert(std::atomic<Context*>::is_always_lock_free, "a signal handler may use it");

void cancel_running(int signal) {
    interrupted = signal;
    if (Context* context = running.load()) context->cancel();
    std::signal(signal, SIG_DFL);
}

}  // namespace

CancelOnInterrupt::CancelOnInterrupt(Context& context) {
    running = &context;
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int signal : signals)
        if (std::signal(signal, cancel_running) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup wants it
}

CancelOnInterrupt::~CancelOnInterrupt() {
    running = nullptr;
    for (const int signal : signals)
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool CancelOnInterrupt::happened() { return interrupted != 0; }

void CancelOnInterrupt::die_of_signal() {
    if (const int signal = interrupted) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace rakelight::cli
