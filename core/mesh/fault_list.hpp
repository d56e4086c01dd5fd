#pragma once

#include "core/base/diagnostic.hpp"

#include <initializer_list>
#include <string>

namespace forefront {

/// Collects faults up to a limit and counts the rest.
class FaultList {
  public:
    explicit FaultList(std::size_t limit) : limit_(limit) {}

    void add(const char *code, std::string message, std::optional<Vec2> at = {},
             std::initializer_list<std::uint32_t> ids = {}) {
        ++count_;
        if (faults_.size() < limit_) {
            Diagnostic fault;
            fault.code = code;
            fault.message = std::move(message);
            fault.at = at;
            fault.ids = ids;
            faults_.push_back(std::move(fault));
        }
    }
    std::size_t count() const { return count_; }
    bool clean() const { return count_ == 0; }

    /// The faults, with a last note where some were left out.
    Diagnostics take() {
        if (count_ > faults_.size()) {
            Diagnostic rest;
            rest.severity = faults_.empty() ? Severity::Error : Severity::Note;
            rest.code = "more";
            rest.message = std::to_string(count_ - faults_.size()) + " more faults are not listed";
            faults_.push_back(std::move(rest));
        }
        return std::move(faults_);
    }

  private:
    std::size_t limit_;
    std::size_t count_ = 0;
    Diagnostics faults_;
};

} // namespace forefront
