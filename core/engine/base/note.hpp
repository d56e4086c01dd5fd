#pragma once

#include "core/engine/base/diagnostic.hpp"

#include <string>
#include <utility>

namespace forefront {

/// Returns a note; code, message and advice are those of Diagnostic.
inline Diagnostic noteOf(std::string code, std::string message, std::string advice = {}) {
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = std::move(code);
    note.message = std::move(message);
    note.advice = std::move(advice);
    return note;
}

/// Returns a warning; code, message and advice are those of Diagnostic.
inline Diagnostic warningOf(std::string code, std::string message, std::string advice = {}) {
    Diagnostic warning = noteOf(std::move(code), std::move(message), std::move(advice));
    warning.severity = Severity::Warning;
    return warning;
}

} // namespace forefront
