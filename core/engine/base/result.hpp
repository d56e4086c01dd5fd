#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/assert.hpp"
#include "core/engine/base/diagnostic.hpp"

#include <utility>
#include <variant>

namespace FOREFRONT_API forefront {

/// A value, or the diagnostics (never empty) that explain why there is none.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : content_(std::move(value)) {}
    Result(Diagnostics faults) : content_(std::move(faults)) { FOREFRONT_ASSERT(!this->faults().empty()); }

    explicit operator bool() const { return std::holds_alternative<T>(content_); }
    bool ok() const { return static_cast<bool>(*this); }
    T &value() & { return std::get<T>(content_); }
    const T &value() const & { return std::get<T>(content_); }
    T &&value() && { return std::get<T>(std::move(content_)); }
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
    const Diagnostics &faults() const { return std::get<Diagnostics>(content_); }

  private:
    std::variant<T, Diagnostics> content_;
};

/// Outcome of an operation without a result: empty on success.
using Status = Diagnostics;

} // namespace forefront
