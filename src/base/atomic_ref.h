// SPDX-License-Identifier: Apache-2.0
// std::atomic_ref, which libc++ before 19 lacks.
#pragma once
#include <atomic>

namespace rakelight {

#if defined(__cpp_lib_atomic_ref)
using std::atomic_ref;
#else
template <class T>
class atomic_ref {
public:
    explicit atomic_ref(T& value) : value_(value) {}
    T load(std::memory_order = {}) const { return __atomic_load_n(&value_, __ATOMIC_SEQ_CST); }
    void store(T value, std::memory_order = {}) const { __atomic_store_n(&value_, value, __ATOMIC_SEQ_CST); }
    T fetch_add(T value, std::memory_order = {}) const { return __atomic_fetch_add(&value_, value, __ATOMIC_SEQ_CST); }
    T fetch_or(T value, std::memory_order = {}) const { return __atomic_fetch_or(&value_, value, __ATOMIC_SEQ_CST); }
    bool compare_exchange_weak(T& expected, T value, std::memory_order = {}) const {
        return __atomic_compare_exchange_n(&value_, &expected, value, true, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);
    }

private:
    T& value_;
};
#endif

}  // namespace rakelight
