#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/vec2.hpp"

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

/// Collects the faults of a domain: lists the first ones, and counts the rest.
class DomainFaultList {
  public:
    /// `limit`: maximum number of faults that take() lists.
    explicit DomainFaultList(std::size_t limit) : limit_(limit) {}

    void add(const char *code, std::string message, std::string advice, std::optional<Vec2> at,
             std::initializer_list<DomainPart> parts) {
        ++count_;
        if (full()) {
            return;
        }
        Diagnostic fault;
        fault.code = code;
        fault.message = std::move(message);
        fault.advice = std::move(advice);
        fault.at = at && isFinite(*at) ? at : std::nullopt;
        fault.parts = parts;
        faults_.push_back(std::move(fault));
    }
    /// Counts faults without listing them.
    void addUnlisted(std::size_t count) { count_ += count; }
    /// States that the search for faults stopped early, so that the count is a minimum.
    void setIncomplete() { complete_ = false; }

    std::size_t limit() const { return limit_; }
    bool full() const { return faults_.size() >= limit_; }

    /// Returns the listed faults; a last one tells how many more there are.
    Diagnostics take() {
        if (count_ > faults_.size() || !complete_) {
            Diagnostic rest;
            rest.severity = faults_.empty() ? Severity::Error : Severity::Note;
            rest.code = "more-faults";
            const std::size_t more = count_ - faults_.size();
            rest.message = more == 0
                               ? "the search stopped after " + std::to_string(count_) + " faults; there may be more"
                               : (complete_ ? "" : "at least ") + std::to_string(more) + " more faults are not listed";
            faults_.push_back(std::move(rest));
        }
        return std::move(faults_);
    }

  private:
    std::size_t limit_;
    std::size_t count_ = 0;
    Diagnostics faults_;
    bool complete_ = true;
};

} // namespace forefront
