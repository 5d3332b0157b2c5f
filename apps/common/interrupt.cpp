// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include <atomic>
#include <utility>

#include <rakelight_internal/io/unfinished_outputs.h>

#ifdef __GLIBC__
/// Mesa lowers its thread that writes the cache of shaders to nice 19. A process is gone only when each of its threads
/// has run once more, and on a busy machine such a thread waits for seconds. So threads of the programs keep their
/// priority: libraries find this function before that of libc.
extern "C" __attribute__((visibility("default"))) int setpriority(__priority_which_t, id_t, int) noexcept { return 0; }
#endif

namespace rakelight::apps {
namespace {

constexpr int patience_us = 300'000;
constexpr const char* plain_words = "rakelight: error: cancelled\n";
constexpr int not_settled = -1;
std::atomic<Context*> running{nullptr};
std::atomic<const char*> last_words{plain_words};
std::atomic<int> interrupted{0};                                            // the signal
std::atomic<bool> may_finish{false}, is_cut_short{false}, are_said{false};  // the words of the end
std::atomic<int> settled_code{not_settled};                                 // of a program whose work is done
constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
static_assert(std::atomic<Context*>::is_always_lock_free, "a signal handler may use it");

/// Calls a signal handler in `us` microseconds; never where 0.
void set_alarm(int us) {
    itimerval time{};
    time.it_value.tv_usec = us;
    setitimer(ITIMER_REAL, &time, nullptr);  // a system call and nothing else: fit for a signal handler
}

void say_last_words() {
    const char* const words = last_words.exchange("");
    static_cast<void>(!write(STDERR_FILENO, words, std::strlen(words)));
}

void die_of_signal() {
    std::signal(interrupted, SIG_DFL);
    std::raise(interrupted);
}

/// A signal handler: the program ends without its destructors.
void end_at_once(int) {
    if (settled_code != not_settled) _exit(settled_code);
    remove_unfinished_outputs();
    say_last_words();
    die_of_signal();
}

void cancel_running(int signal) {
    interrupted = signal;
    if (Context* context = running.load()) context->cancel();
    std::signal(signal, end_at_once);
    if (!may_finish) set_alarm(patience_us);
}

/// What nohup ignores stays ignored.
void handle_signals(void (*handler)(int)) {
    for (const int signal : signals)
        if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

CancelOnInterrupt::CancelOnInterrupt(Context& context, std::string words) : last_words_(std::move(words)) {
    running = &context;
    if (!are_said) last_words = last_words_.c_str();
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGALRM, end_at_once);
    if (interrupted)
        context.cancel();
    else
        handle_signals(cancel_running);
}

CancelOnInterrupt::~CancelOnInterrupt() {
    running = nullptr;
    const char* mine = last_words_.c_str();
    last_words.compare_exchange_strong(mine, plain_words);  // where they were said, there are none any more
}

bool CancelOnInterrupt::happened() {
    if (interrupted) is_cut_short = true;
    return interrupted != 0;
}

void CancelOnInterrupt::words_are_said() {
    if (!happened()) return;
    are_said = true;
    last_words = "";
    if (!may_finish) set_alarm(patience_us);  // again, so that it does not end within the words
}

void CancelOnInterrupt::let_finish() { may_finish = true; }

void CancelOnInterrupt::stand_by() {
    if (!interrupted) handle_signals(SIG_DFL);
}

int CancelOnInterrupt::end_by_signal(int code) {
    if (interrupted && is_cut_short) {
        say_last_words();
        die_of_signal();
    }
    settled_code = code;
    return code;
}

}  // namespace rakelight::apps
