// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/memory_budget.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <rakelight/base/error.h>

#include "base/assert.h"
#include "base/format_text.h"

namespace rakelight {

/// Shared by a budget and its charges, so that these may outlive it.
struct MemoryBudget::Account {
    explicit Account(std::uint64_t max) : max_bytes(max) {}
    std::uint64_t limit() const noexcept;
    void require(std::uint64_t before, std::uint64_t bytes, std::string_view what);
    void charge(std::uint64_t bytes, std::string_view what);
    void give_back(std::uint64_t bytes) noexcept;

    const std::uint64_t max_bytes;  ///< 0: the default
    std::atomic<std::uint64_t> read_bytes{0}, charged{0}, refusals{0};
};

namespace {

constexpr std::uint64_t default_limit = 2ull << 30;
constexpr std::uint64_t bytes_per_byte_read = 64;

std::string too_much(std::string_view what, std::uint64_t bytes, std::uint64_t used, std::uint64_t limit) {
    return format_text("{}: {} bytes{}, more than the limit of {}", what, bytes,
                       used > 0 ? format_text(" beside {} in use", used) : "", limit);
}

}  // namespace

/// Never more than can be addressed: what was charged may be cast to std::size_t, also where that has 32 bits.
std::uint64_t MemoryBudget::Account::limit() const noexcept {
    constexpr std::uint64_t addressable = std::numeric_limits<std::size_t>::max();
    if (max_bytes != 0) return std::min(max_bytes, addressable);
    const std::uint64_t read = read_bytes;
    const std::uint64_t explained = read > ~0ull / bytes_per_byte_read ? ~0ull : read * bytes_per_byte_read;
    return std::min(std::max(explained, default_limit), addressable);
}

void MemoryBudget::Account::require(std::uint64_t before, std::uint64_t bytes, std::string_view what) {
    const std::uint64_t allowed = limit();
    if (bytes <= allowed && before <= allowed - bytes) return;
    ++refusals;
    throw Error(ErrorCode::bad_file, too_much(what, bytes, before, allowed), {},
                "raise it with 'max-memory' if you trust the file")
        .naming({"max-memory"});
}

void MemoryBudget::Account::charge(std::uint64_t bytes, std::string_view what) {
    std::uint64_t before = charged;
    do require(before, bytes, what);  // retried if another thread charged in between
    while (!charged.compare_exchange_weak(before, before + bytes));
}

/// Bytes read only raise the limit for data made from them: with the last charge the limit returns to its initial
/// value, so that a long-lived context protects as well as a new one.
void MemoryBudget::Account::give_back(std::uint64_t bytes) noexcept {
    if (bytes > 0 && charged.fetch_sub(bytes) == bytes) read_bytes = 0;
}

MemoryBudget::MemoryBudget(std::uint64_t max_bytes) : account_(std::make_shared<Account>(max_bytes)) {}

void MemoryBudget::check(std::uint64_t bytes, std::string_view what) const {
    account_->require(account_->charged, bytes, what);
}
std::uint64_t MemoryBudget::charged() const noexcept { return account_->charged; }
std::uint64_t MemoryBudget::limit() const noexcept { return account_->limit(); }
std::uint64_t MemoryBudget::refusals() const noexcept { return account_->refusals; }

MemoryCharge::MemoryCharge(MemoryBudget& budget, std::uint64_t bytes, std::string_view what) {
    budget.account_->charge(bytes, what);
    account_ = budget.account_;
    bytes_ = bytes;
}

MemoryCharge MemoryCharge::of_file(MemoryBudget& budget, std::uint64_t bytes, std::string_view what) {
    MemoryBudget::Account& account = *budget.account_;
    MemoryCharge charge(budget);
    charge.bytes_ = bytes;  // released by the destructor if it is refused
    const std::uint64_t before = account.charged.fetch_add(bytes);
    account.read_bytes += bytes;
    account.require(before, bytes, what);
    return charge;
}

MemoryCharge::MemoryCharge(MemoryCharge&& from) noexcept
    : account_(std::move(from.account_)), bytes_(from.bytes_.exchange(0)) {}

MemoryCharge& MemoryCharge::operator=(MemoryCharge&& from) noexcept {
    MemoryCharge old(std::move(*this));  // releases the previous charge
    account_ = std::move(from.account_);
    bytes_ = from.bytes_.exchange(0);
    return *this;
}

MemoryCharge::~MemoryCharge() {
    if (account_) account_->give_back(bytes_);
}

void MemoryCharge::grow(std::uint64_t bytes, std::string_view what) {
    RL_ASSERT(account_, "a charge of no budget cannot grow");
    account_->charge(bytes, what);
    bytes_ += bytes;
}

void MemoryCharge::shrink(std::uint64_t bytes) noexcept {
    if (!account_) return;
    std::uint64_t own = bytes_, less;
    do less = std::min(bytes, own);
    while (!bytes_.compare_exchange_weak(own, own - less));
    account_->give_back(less);
}

MemoryCharge MemoryCharge::split(std::uint64_t bytes) noexcept {
    MemoryCharge part;
    part.account_ = account_;
    part.bytes_ = std::min(bytes, bytes_.load());
    bytes_ -= part.bytes_;
    return part;
}

}  // namespace rakelight
