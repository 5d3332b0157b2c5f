// SPDX-License-Identifier: Apache-2.0
// How much memory the data of untrusted files may ask for, and the charges that keep count of what is alive.
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>

#include <rakelight/export.h>

namespace rakelight {

/// The limit: 2 GiB, or 64 bytes for each byte read where that is more, or what the user allows. Thread-safe.
class RL_API MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t max_bytes = 0);  ///< @param max_bytes  [bytes]; 0: the rule above
    MemoryBudget(const MemoryBudget&) = delete;
    MemoryBudget& operator=(const MemoryBudget&) = delete;

    /// Tells how many bytes were read from files; raises the allowance until all charges have ended. Where the bytes are
    /// charged themselves, MemoryCharge::of_file() does both.
    void note_read(std::uint64_t bytes) noexcept;
    /// Asks whether `bytes` would be granted now, without keeping them: for buffers that live only for a moment.
    /// @throws Error bad_file, as MemoryCharge
    void check(std::uint64_t bytes, std::string_view what) const;
    std::uint64_t charged() const noexcept;  ///< [bytes] of all charges alive
    std::uint64_t limit() const noexcept;    ///< [bytes] in force now
    /// Charges and checks that were refused so far.
    std::uint64_t refusals() const noexcept;

private:
    friend class MemoryCharge;
    struct Account;
    std::shared_ptr<Account> account_;
};

/// Bytes that stay charged while this lives. It belongs beside what it pays for, so that both end together, by an
/// exception too; it may outlive the budget. The empty charge pays for nothing.
class RL_API MemoryCharge {
public:
    MemoryCharge() = default;
    /// An empty charge that can grow.
    explicit MemoryCharge(MemoryBudget& budget) : account_(budget.account_) {}
    /// To be made before memory is asked for whose size a file decides.
    /// @throws Error bad_file "WHAT: N bytes beside U in use, more than the limit of M". Nothing is charged then.
    MemoryCharge(MemoryBudget& budget, std::uint64_t bytes, std::string_view what);
    /// The charge of bytes that are read from a file, which raise the allowance before they count.
    /// @throws Error bad_file, as the constructor
    static MemoryCharge of_file(MemoryBudget& budget, std::uint64_t bytes, std::string_view what);
    MemoryCharge(MemoryCharge&& from) noexcept;
    MemoryCharge& operator=(MemoryCharge&& from) noexcept;
    ~MemoryCharge();

    /// Adds to it; thread-safe, as shrink() is. Not of a charge that was made without a budget.
    /// @throws Error bad_file, as the constructor; the charge is as before then
    void grow(std::uint64_t bytes, std::string_view what);
    /// Gives part of it back, or all where it has less.
    void shrink(std::uint64_t bytes) noexcept;
    /// Part of it, or all where it has less, as a charge of its own.
    MemoryCharge split(std::uint64_t bytes) noexcept;
    /// [bytes] that it pays for
    std::uint64_t bytes() const noexcept { return bytes_; }

private:
    std::shared_ptr<MemoryBudget::Account> account_;
    std::atomic<std::uint64_t> bytes_{0};
};

/// A charge with several owners: the last one gives it back.
using SharedCharge = std::shared_ptr<const MemoryCharge>;
/// Makes a charge one of several owners.
inline SharedCharge share(MemoryCharge charge) { return std::make_shared<const MemoryCharge>(std::move(charge)); }

}  // namespace rakelight
