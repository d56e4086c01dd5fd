#include "core/files/source/import_notes.hpp"

#include "core/files/source/text_place.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// A message split into its fixed text and its quoted names: "'a', 'b'".
struct Quoting {
    std::string frame, quoted;
    std::size_t quotes = 0;
};

bool opensQuote(const std::string &text, std::size_t at) {
    return text[at] == '\'' && (at == 0 || text[at - 1] == ' ' || text[at - 1] == '(');
}

/// Returns where a quote that opens at a place closes; npos if it does not. Names may have apostrophes.
std::size_t closingQuote(const std::string &text, std::size_t open) {
    for (std::size_t at = text.find('\'', open + 1); at != std::string::npos; at = text.find('\'', at + 1)) {
        if (at + 1 == text.size() || std::string_view(" ,.;:)").find(text[at + 1]) != std::string_view::npos) {
            return at;
        }
    }
    return std::string::npos;
}

Quoting quotingOf(const std::string &message) {
    Quoting parts;
    for (std::size_t at = 0; at < message.size();) {
        const std::size_t end = opensQuote(message, at) ? closingQuote(message, at) : std::string::npos;
        if (end == std::string::npos) {
            parts.frame += message[at++];
            continue;
        }
        parts.quoted += (parts.quoted.empty() ? "" : ", ") + message.substr(at, end + 1 - at);
        parts.frame += '\'';
        ++parts.quotes;
        at = end + 1;
    }
    return parts;
}

/// Notes whose messages differ only in what they quote.
struct NoteKind {
    std::size_t count = 0; ///< of all together
    std::vector<const Quoting *> quotings;

    bool joined() const {
        constexpr std::size_t kFew = 5; // each is shown with its own place
        return quotings.size() > kFew;
    }

    /// Returns "(9 times; also 'b', 'c')".
    std::string text() const {
        constexpr std::size_t kShown = 8;
        std::string text = " (" + std::to_string(count) + " times";
        for (std::size_t k = 1; k < std::min(quotings.size(), kShown); ++k) {
            text += (k == 1 ? "; also " : quotings[k]->quotes > 1 ? "; " : ", ") + quotings[k]->quoted;
        }
        return text + (quotings.size() > kShown ? " and others)" : ")");
    }
};

} // namespace

void ImportNotes::add(std::string_view code, const std::string &message, const std::string &file, std::string_view text,
                      std::size_t offset, std::size_t count, Severity severity) {
    constexpr std::size_t kMaxEntries = 200; // then, notes that differ in their message alone are counted together
    const bool full = entries_.size() >= kMaxEntries;
    const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const ImportNote &note) {
        return note.code == code && (full || note.message == message) && note.file == file;
    });
    if (known != entries_.end()) {
        known->count += count;
        return;
    }
    const TextPlace place = placeOf(text, offset);
    entries_.push_back({std::string(code), message, count, file, place.line, place.column, severity});
}

Diagnostics ImportNotes::diagnostics() const {
    std::vector<Quoting> quotings;
    quotings.reserve(entries_.size());
    std::map<std::tuple<std::string, std::string, std::string>, NoteKind> kinds;
    std::vector<const NoteKind *> kindOf;
    for (const ImportNote &note : entries_) {
        quotings.push_back(quotingOf(note.message));
        NoteKind &kind = kinds[{note.code, note.file, quotings.back().frame}];
        kind.count += note.count;
        kind.quotings.push_back(&quotings.back());
        kindOf.push_back(&kind);
    }
    Diagnostics list;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        const ImportNote &note = entries_[k];
        const NoteKind &kind = *kindOf[k];
        if (kind.joined() && kind.quotings.front() != &quotings[k]) {
            continue;
        }
        Diagnostic entry;
        entry.severity = note.severity;
        entry.code = note.code;
        entry.message = note.message;
        if (kind.joined()) {
            entry.message += kind.text();
        } else if (note.count > 1) {
            entry.message += " (" + std::to_string(note.count) + " times)";
        }
        entry.file = note.file;
        entry.line = note.line;
        entry.column = note.column;
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace forefront
