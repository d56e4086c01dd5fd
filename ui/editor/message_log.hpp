#pragma once

#include "core/base/diagnostic.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>

namespace forefront {

/// What the program has to say, newest last. Entries with a place can be gone to.
class MessageLog {
  public:
    struct Entry {
        Diagnostic diagnostic;
        double time = 0.0;          ///< Platform::now() when it was added
        std::uint64_t number = 0;   ///< counts up from 1
        std::uint64_t revision = 0; ///< of the document it speaks of
        bool told = false;          ///< shown on the canvas for some seconds, too
    };
    static constexpr std::size_t kLimit = 1000;

    /// A fault of the document of `revision`; none: of the current one.
    void add(Diagnostic diagnostic, std::optional<std::uint64_t> revision = {}) {
        const bool told = diagnostic.severity != Severity::Note;
        push(std::move(diagnostic), told, revision);
    }
    void add(const Diagnostics &diagnostics, std::optional<std::uint64_t> revision = {}) {
        for (const Diagnostic &diagnostic : diagnostics) {
            add(diagnostic, revision);
        }
    }
    /// Something the user sees happen anyway: for the log alone.
    void note(std::string message) { push({.severity = Severity::Note, .message = std::move(message)}, false, {}); }
    /// The outcome of something the user asked for and cannot see otherwise.
    void tell(std::string message) { push({.severity = Severity::Note, .message = std::move(message)}, true, {}); }
    /// Faults that a dialog shows itself.
    void keep(const Diagnostics &diagnostics) {
        for (const Diagnostic &diagnostic : diagnostics) {
            push(diagnostic, false, {});
        }
    }
    void clear() { entries_.clear(); }
    const std::deque<Entry> &entries() const { return entries_; }
    void setTime(double now) { time_ = now; }
    /// Where to ask for the revision of the current document.
    void follow(std::function<std::uint64_t()> revision) { revision_ = std::move(revision); }

  private:
    void push(Diagnostic diagnostic, bool told, std::optional<std::uint64_t> revision) {
        const std::uint64_t current = revision_ ? revision_() : 0;
        entries_.push_back({std::move(diagnostic), time_, ++count_, revision.value_or(current), told});
        if (entries_.size() > kLimit) {
            entries_.pop_front();
        }
    }

    std::deque<Entry> entries_;
    std::uint64_t count_ = 0;
    double time_ = 0.0;
    std::function<std::uint64_t()> revision_;
};

} // namespace forefront
