// SPDX-License-Identifier: Apache-2.0
// Long work without the GIL: it runs on a thread of its own, while the caller's thread checks for signals and reports progress.
#pragma once
#include <pybind11/pybind11.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>

#include <rakelight/base/context.h>

namespace rakelight::python {

namespace py = pybind11;

/// Cancels the calls that daemon threads are in, and waits for their work to end. For Py_AtExit(): when the interpreter is
/// gone and before the memory that they use is.
void cancel_all();

/// A context, and the work that is done with it.
class Runner {
public:
    Runner(int threads, std::uint64_t max_memory);  ///< @throws Error usage: threads out of range
    Context& context() { return *context_; }

    /// Calls work() without the GIL and returns what it returns. Work must not touch Python.
    /// @param progress  called as progress(stage, fraction); None: nobody asks
    /// @throws what work throws; what a signal's handler (KeyboardInterrupt) or `progress` raises: the work was cancelled then
    template <class Work>
    auto run(const py::object& progress, const Work& work) {
        using Result = std::invoke_result_t<const Work&>;
        if constexpr (std::is_void_v<Result>) {
            run_on_thread(progress, [&] { work(); });
        } else {
            std::optional<Result> result;
            run_on_thread(progress, [&] { result.emplace(work()); });
            return std::move(*result);
        }
    }

private:
    void run_on_thread(const py::object& progress, const std::function<void()>& work);

    /// What was told last.
    struct Progress {
        std::mutex mutex;
        std::string stage;
        double fraction = 0;
        bool is_new = false;
    };
    void tell(const py::object& progress);
    std::shared_ptr<Progress> progress_ = std::make_shared<Progress>();
    std::unique_ptr<Context> context_;
};

}  // namespace rakelight::python
