// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include <atomic>

#include <rakelight/tools/unfinished_outputs.h>

#include "console.h"

namespace rakelight::cli {
namespace {

constexpr int patience_us = 300'000;
std::atomic<Context*> running{nullptr};
std::atomic<const char*> last_words{""};
std::atomic<int> interrupted{0};  // the signal
std::atomic<bool> may_finish{false};
constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
static_assert(std::atomic<Context*>::is_always_lock_free, "a signal handler may use it");

/// Calls a signal handler in `us` microseconds; never where 0.
void set_alarm(int us) {
    itimerval time{};
    time.it_value.tv_usec = us;
    setitimer(ITIMER_REAL, &time, nullptr);  // a system call and nothing else: fit for a signal handler
}

/// A signal handler: the program ends without its destructors.
void end_at_once(int) {
    const char* words = last_words.load();
    remove_unfinished_outputs();
    static_cast<void>(!write(STDERR_FILENO, words, std::strlen(words)));
    CancelOnInterrupt::die_of_signal();
}

void cancel_running(int signal) {
    interrupted = signal;
    if (Context* context = running.load()) context->cancel();
    std::signal(signal, end_at_once);
    if (!may_finish) set_alarm(patience_us);
}

}  // namespace

CancelOnInterrupt::CancelOnInterrupt(Context& context, const std::string& file)
    : last_words_(error_line(Error(ErrorCode::failed, "cancelled").with_file(file))) {
    running = &context;
    last_words = last_words_.c_str();
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGALRM, end_at_once);
    for (const int signal : signals)
        if (std::signal(signal, cancel_running) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup wants it
}

CancelOnInterrupt::~CancelOnInterrupt() {
    for (const int signal : signals)
        if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);
    set_alarm(0);
    running = nullptr;
    last_words = "";
}

bool CancelOnInterrupt::happened() { return interrupted != 0; }

void CancelOnInterrupt::let_finish() { may_finish = true; }

void CancelOnInterrupt::die_of_signal() {
    if (const int signal = interrupted) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace rakelight::cli
