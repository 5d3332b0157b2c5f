// SPDX-License-Identifier: Apache-2.0
#include "run.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>
#include <vector>

namespace rakelight::python {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);  ///< at signals and progress

/// Work on a thread, and when it is done.
class Work {
public:
    explicit Work(const std::function<void()>& work)
        : thread_([this, &work] {
              try {
                  work();
              } catch (...) {
                  error_ = std::current_exception();
              }
              const std::lock_guard lock(mutex_);
              is_done_ = true;
              done_.notify_all();
          }) {}

    bool wait() {
        std::unique_lock lock(mutex_);
        return done_.wait_for(lock, between_looks, [this] { return is_done_; });
    }
    /// @return what it threw
    std::exception_ptr join() {
        thread_.join();
        return error_;
    }

private:
    std::mutex mutex_;
    std::condition_variable done_;
    bool is_done_ = false;
    std::exception_ptr error_;
    std::thread thread_;  // last: it uses the others
};

/// Calls what may end this thread. While the interpreter finishes, Python ends each thread that asks for the GIL, by
/// pthread_exit(): it unwinds the stack, and frames that are noexcept, or own a running thread, end the process then.
/// So the thread stays here, without the GIL, until the process has ended.
template <class Function>
auto in_python(const Function& call) {
    try {
        return call();  // functions of C: nothing but pthread_exit() is thrown
    } catch (...) {
        for (;;) pause();
    }
}

/// A call that runs.
struct Call {
    Work* work;
    Context* context;
    pid_t process;  ///< a fork has the list, but none of the threads
};
/// All calls that run. It changes with the GIL alone, and is read when nobody can get that any more.
std::vector<Call> calls;

/// In the list as long as it exists.
class Listed {
public:
    Listed(Work& work, Context& context) : work_(&work) { calls.push_back({&work, &context, getpid()}); }
    Listed(const Listed&) = delete;
    Listed& operator=(const Listed&) = delete;
    ~Listed() {
        std::erase_if(calls, [this](const Call& call) { return call.work == work_; });
    }

private:
    Work* work_;
};

}  // namespace

Runner::Runner(int threads, std::uint64_t max_memory) {
    ContextOptions options;
    options.threads = threads;
    options.max_memory = max_memory;
    options.progress = [p = progress_](std::string_view stage, double fraction) {
        const std::lock_guard lock(p->mutex);
        p->stage = stage, p->fraction = fraction, p->is_new = true;
    };
    context_ = std::make_unique<Context>(std::move(options));
}

void Runner::tell(const py::object& progress) {
    std::string stage;
    double fraction = 0;
    {
        const std::lock_guard lock(progress_->mutex);
        if (!progress_->is_new) return;
        stage = progress_->stage, fraction = progress_->fraction, progress_->is_new = false;
    }
    const py::str name(stage);
    const py::float_ share(fraction);
    PyObject* const result =
        in_python([&] { return PyObject_CallFunctionObjArgs(progress.ptr(), name.ptr(), share.ptr(), nullptr); });
    if (!result) throw py::error_already_set();
    Py_DECREF(result);
}

void Runner::run_on_thread(const py::object& progress, const std::function<void()>& work) {
    Work running(work);
    const Listed listed(running, *context_);
    const bool tells = progress && !progress.is_none();
    std::exception_ptr interruption;
    for (bool is_done = false; !is_done;) {
        PyThreadState* const thread = PyEval_SaveThread();
        is_done = running.wait();
        in_python([thread] { PyEval_RestoreThread(thread); });
        if (interruption) continue;  // it is cancelled: the rest is waiting
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (tells) tell(progress);
        } catch (py::error_already_set&) {
            interruption = std::current_exception();
            context_->cancel();
        }
    }
    const std::exception_ptr error = running.join();
    context_->reset_cancel();
    if (interruption) std::rethrow_exception(interruption);
    if (error) std::rethrow_exception(error);
}

void cancel_all() {
    for (const Call& call : calls) {
        if (call.process != getpid()) continue;
        call.context->cancel();
        while (!call.work->wait()) {
        }
    }
}

}  // namespace rakelight::python
