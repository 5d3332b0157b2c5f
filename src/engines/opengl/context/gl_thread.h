// SPDX-License-Identifier: Apache-2.0
// A dedicated thread for things that only one thread may use.
#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace rakelight::opengl {

/// Runs calls one by one on its thread; who calls waits for the end. From any thread.
class GlThread {
public:
    GlThread() : thread_([this] { run(); }) {}
    ~GlThread() {
        call([this] { ends_ = true; });
        thread_.join();
    }
    GlThread(const GlThread&) = delete;
    GlThread& operator=(const GlThread&) = delete;

    /// Rethrows what `work` throws.
    void call(const std::function<void()>& work) {
        const std::lock_guard one_at_a_time(calls_);
        std::unique_lock lock(mutex_);
        work_ = &work;
        changed_.notify_all();
        changed_.wait(lock, [this] { return work_ == nullptr; });
        if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
    }

private:
    void run() {
        std::unique_lock lock(mutex_);
        while (!ends_) {
            changed_.wait(lock, [this] { return work_ != nullptr; });
            const std::function<void()>& work = *work_;
            lock.unlock();
            std::exception_ptr fault;
            try {
                work();
            } catch (...) {
                fault = std::current_exception();
            }
            lock.lock();
            fault_ = fault;
            work_ = nullptr;
            changed_.notify_all();
        }
    }

    std::mutex calls_, mutex_;
    std::condition_variable changed_;
    const std::function<void()>* work_ = nullptr;
    std::exception_ptr fault_;
    bool ends_ = false;
    std::thread thread_;  // last: it begins when all else is there
};

}  // namespace rakelight::opengl
