#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

/// Collects the faults of a check. A kind of fault, by its code, that occurs often is listed once with its count.
class FaultList {
  public:
    /// `limit`: maximum number of faults that take() lists.
    explicit FaultList(std::size_t limit) : limit_(limit) {}

    void add(const char *code, std::string message, std::optional<Vec2> at = {},
             std::initializer_list<std::uint32_t> ids = {}, std::initializer_list<DomainPart> parts = {}) {
        ++errors_;
        push(Severity::Error, code, std::move(message), at, ids, parts);
    }
    /// Adds something that makes a mesh unfit for most uses but not invalid.
    void warn(const char *code, std::string message, std::optional<Vec2> at = {},
              std::initializer_list<std::uint32_t> ids = {}) {
        push(Severity::Warning, code, std::move(message), at, ids, {});
    }
    /// Adds a note, which is no fault: neither counted nor limited.
    void note(const char *code, std::string message, std::optional<Vec2> at, std::initializer_list<std::uint32_t> ids) {
        Diagnostic &entry = notes_.emplace_back();
        entry.severity = Severity::Note;
        entry.code = code;
        entry.message = std::move(message);
        entry.at = at;
        entry.ids = ids;
    }
    /// Returns the number of errors.
    std::size_t errors() const { return errors_; }
    bool clean() const { return errors_ == 0; }

    /// Returns the errors, then the warnings, in the order they were added, with a note of the number beyond the limit,
    /// then the notes.
    Diagnostics take() {
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](const Diagnostic &a, const Diagnostic &b) { return a.severity < b.severity; });
        Diagnostics listed;
        std::size_t covered = 0; // faults that the list names or counts
        for (Diagnostic &fault : faults_) {
            Kind &kind = kindOf(fault.code);
            const bool often = kind.count > kOften;
            if (listed.size() == limit_ || (often && kind.listed)) {
                continue;
            }
            kind.listed = true;
            covered += often ? kind.count : 1;
            if (often) {
                fault.message += " (the first of " + std::to_string(kind.count) + " such faults)";
            }
            listed.push_back(std::move(fault));
        }
        if (covered < count_) {
            Diagnostic rest;
            rest.severity = listed.empty() && errors_ > 0 ? Severity::Error : Severity::Note;
            rest.code = "more";
            rest.message = std::to_string(count_ - covered) + " more faults are not listed";
            listed.push_back(std::move(rest));
        }
        std::move(notes_.begin(), notes_.end(), std::back_inserter(listed));
        return listed;
    }

  private:
    void push(Severity severity, const char *code, std::string message, std::optional<Vec2> at,
              std::initializer_list<std::uint32_t> ids, std::initializer_list<DomainPart> parts) {
        ++count_;
        if (++kindOf(code).count > kOften) {
            return;
        }
        Diagnostic fault;
        fault.severity = severity;
        fault.code = code;
        fault.message = std::move(message);
        fault.at = at;
        fault.ids = ids;
        fault.parts = parts;
        faults_.push_back(std::move(fault));
    }

    /// Kinds with more faults are listed once.
    static constexpr std::size_t kOften = 10;

    struct Kind {
        std::string code;
        std::size_t count = 0;
        bool listed = false;
    };
    Kind &kindOf(std::string_view code) {
        const auto found =
            std::find_if(kinds_.begin(), kinds_.end(), [code](const Kind &kind) { return kind.code == code; });
        return found != kinds_.end() ? *found : kinds_.emplace_back(Kind{std::string(code)});
    }

    std::size_t limit_;
    std::size_t count_ = 0; ///< of errors and warnings
    std::size_t errors_ = 0;
    std::vector<Kind> kinds_; ///< few
    Diagnostics faults_;      ///< the first of each kind
    Diagnostics notes_;
};

} // namespace forefront
