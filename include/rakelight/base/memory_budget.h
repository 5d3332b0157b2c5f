// SPDX-License-Identifier: Apache-2.0
// The memory budget for data of untrusted files, and the charges that count live allocations.
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>

#include <rakelight/base/export.h>

namespace rakelight {

/// The budget. Its default limit is 2 GiB, or 64 times the bytes read from files if that is more. Thread-safe.
class RL_API MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t max_bytes = 0);  ///< @param max_bytes  [bytes] limit; 0: the default limit
    MemoryBudget(const MemoryBudget&) = delete;
    MemoryBudget& operator=(const MemoryBudget&) = delete;

    /// Checks that `bytes` are available now, without a charge. For short-lived buffers.
    /// @throws Error bad_file, as the constructor of MemoryCharge
    void check(std::uint64_t bytes, std::string_view what) const;
    std::uint64_t charged() const noexcept;  ///< [bytes] sum of all live charges
    std::uint64_t limit() const noexcept;    ///< [bytes] current limit
    /// Number of refused charges and checks.
    std::uint64_t refusals() const noexcept;

private:
    friend class MemoryCharge;
    struct Account;
    std::shared_ptr<Account> account_;
};

/// An RAII charge of bytes. Store the charge next to its memory, so that both end together. A charge may outlive the
/// budget. The default is empty.
class RL_API MemoryCharge {
public:
    MemoryCharge() = default;
    /// An empty charge that may grow.
    explicit MemoryCharge(MemoryBudget& budget) : account_(budget.account_) {}
    /// Charges `bytes`. Create the charge before an allocation whose size comes from a file.
    /// @throws Error bad_file "WHAT: N bytes beside U in use, more than the limit of M". Then nothing is charged.
    MemoryCharge(MemoryBudget& budget, std::uint64_t bytes, std::string_view what);
    /// A charge for bytes read from a file. First the bytes raise the default limit, until all charges have ended.
    /// @throws Error bad_file, as the constructor
    static MemoryCharge of_file(MemoryBudget& budget, std::uint64_t bytes, std::string_view what);
    MemoryCharge(MemoryCharge&& from) noexcept;
    MemoryCharge& operator=(MemoryCharge&& from) noexcept;
    ~MemoryCharge();

    /// Adds bytes. The charge must have a budget. grow() and shrink() are thread-safe.
    /// @throws Error bad_file, as the constructor; the charge is then unchanged
    void grow(std::uint64_t bytes, std::string_view what);
    /// Releases bytes, at most all.
    void shrink(std::uint64_t bytes) noexcept;
    /// Moves bytes, at most all, to a new charge.
    MemoryCharge split(std::uint64_t bytes) noexcept;
    /// [bytes] charged
    std::uint64_t bytes() const noexcept { return bytes_; }

private:
    std::shared_ptr<MemoryBudget::Account> account_;
    std::atomic<std::uint64_t> bytes_{0};
};

/// A charge with several owners; the last one releases it.
using SharedCharge = std::shared_ptr<const MemoryCharge>;
/// Turns a charge into a shared one.
inline SharedCharge share(MemoryCharge charge) { return std::make_shared<const MemoryCharge>(std::move(charge)); }

}  // namespace rakelight
