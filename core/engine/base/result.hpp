#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/assert.hpp"
#include "core/engine/base/diagnostic.hpp"

#include <utility>
#include <variant>

namespace FOREFRONT_API forefront {

/// Prints the first of the diagnostics to stderr and aborts: the value of a failed result was used without a check.
[[noreturn]] void abortWithoutValue(const Diagnostics &faults);
/// Says on stderr that the diagnostics of a successful result were used, and aborts.
[[noreturn]] void abortWithoutFaults();

/// A value, or the diagnostics (never empty) that explain why there is none. Using the value of a failed result prints
/// the first diagnostic to stderr and aborts, in every build.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : content_(std::move(value)) {}
    Result(Diagnostics faults) : content_(std::move(faults)) { FOREFRONT_ASSERT(!this->faults().empty()); }

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
    bool ok() const { return static_cast<bool>(*this); }
    T &value() & {
        check();
        return *std::get_if<T>(&content_);
    }
    const T &value() const & {
        check();
        return *std::get_if<T>(&content_);
    }
    T &&value() && {
        check();
        return std::move(*std::get_if<T>(&content_));
    }
    T &operator*() & { return value(); }
    const T &operator*() const & { return value(); }
    T &&operator*() && { return std::move(*this).value(); }
    T *operator->() { return &value(); }
    const T *operator->() const { return &value(); }
    /// Returns the value or, if there is none, `fallback`.
    template <class U>
    T value_or(U &&fallback) const & {
        return ok() ? value() : static_cast<T>(std::forward<U>(fallback));
    }
    template <class U>
    T value_or(U &&fallback) && {
        return ok() ? std::move(*this).value() : static_cast<T>(std::forward<U>(fallback));
    }
    const Diagnostics &faults() const {
        const Diagnostics *const faults = std::get_if<Diagnostics>(&content_);
        if (faults == nullptr) {
            abortWithoutFaults();
        }
        return *faults;
    }

  private:
    void check() const {
        if (!ok()) {
            abortWithoutValue(faults());
        }
    }

    std::variant<T, Diagnostics> content_;
};

/// Outcome of an operation without a result: empty on success.
using Status = Diagnostics;

} // namespace forefront
