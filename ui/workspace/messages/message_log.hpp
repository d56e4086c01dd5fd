#pragma once

#include "core/engine/base/diagnostic.hpp"
#include "ui/workspace/document/document_store.hpp"
#include "ui/workspace/messages/option_hints.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

/// The messages of the program, newest last. The user can go to the place of an entry that has one.
class MessageLog {
  public:
    struct Entry {
        Diagnostic diagnostic;
        double time = 0.0;          ///< Platform::now() when it was added
        std::uint64_t number = 0;   ///< counts up from 1
        std::uint64_t revision = 0; ///< of the document it is about
        bool announced = false;     ///< also shown on the canvas for a few seconds
        std::string topic;          ///< see note()
    };
    static constexpr std::size_t kLimit = 1000;

    /// Creates a log whose entries are about `document` as it is when they are added, unless they say otherwise.
    explicit MessageLog(const DocumentStore &document) : document_(document) {}

    /// Logs a fault of the document with `revision`, by default the current one.
    void add(Diagnostic diagnostic, std::optional<std::uint64_t> revision = {}) {
        const bool announced = diagnostic.severity != Severity::Note;
        push(std::move(diagnostic), announced, revision);
    }
    void add(const Diagnostics &diagnostics, std::optional<std::uint64_t> revision = {}) {
        for (const Diagnostic &diagnostic : diagnostics) {
            add(diagnostic, revision);
        }
    }
    /// Logs a result that the user sees anyway, without showing it on the canvas. Replaces the newest entry if that has
    /// the same non-empty `topic`, so that a gesture with many results leaves one line.
    void note(std::string message, std::string topic = {}) {
        if (!topic.empty() && !entries_.empty() && entries_.back().topic == topic) {
            entries_.pop_back();
        }
        push({.severity = Severity::Note, .message = std::move(message)}, false, {});
        entries_.back().topic = std::move(topic);
    }
    /// Logs the outcome of a command and shows it on the canvas, where the user could not see it otherwise.
    void announce(std::string message) { push({.severity = Severity::Note, .message = std::move(message)}, true, {}); }
    /// Like announce(), for what is neither a success nor a refusal: shown without a tick.
    void inform(std::string message) {
        push({.severity = Severity::Note, .code = "information", .message = std::move(message)}, true, {});
    }
    /// Logs why a command did nothing and shows it on the canvas, as a warning.
    void refuse(std::string message) {
        add(Diagnostic{.severity = Severity::Warning, .code = "refused", .message = std::move(message)});
    }
    /// Logs faults that a dialog or field already shows.
    void keep(const Diagnostics &diagnostics) {
        for (const Diagnostic &diagnostic : diagnostics) {
            push(diagnostic, false, {});
        }
    }
    void clear() { entries_.clear(); }
    const std::deque<Entry> &entries() const { return entries_; }
    void setTime(double now) { time_ = now; }

  private:
    void push(Diagnostic diagnostic, bool announced, std::optional<std::uint64_t> revision) {
        entries_.push_back({withEditorHints(std::move(diagnostic)),
                            time_,
                            ++count_,
                            revision.value_or(document_.revision()),
                            announced,
                            {}});
        if (entries_.size() > kLimit) {
            entries_.pop_front();
        }
    }

    const DocumentStore &document_;
    std::deque<Entry> entries_;
    std::uint64_t count_ = 0;
    double time_ = 0.0;
};

} // namespace forefront
