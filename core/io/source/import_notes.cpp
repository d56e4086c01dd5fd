#include "core/io/source/import_notes.hpp"

#include "core/io/source/text_place.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace forefront {

namespace {

/// A message without what it quotes, and that: "'a', 'b'".
struct Quoting {
    std::string frame, quoted;
};

Quoting quotingOf(const std::string &message) {
    Quoting parts;
    for (std::size_t at = 0; at < message.size();) {
        const bool opens = message[at] == '\'' && (at == 0 || message[at - 1] == ' ' || message[at - 1] == '(');
        const std::size_t end = opens ? message.find('\'', at + 1) : std::string::npos;
        if (end == std::string::npos) {
            parts.frame += message[at++];
            continue;
        }
        parts.quoted += (parts.quoted.empty() ? "" : ", ") + message.substr(at, end + 1 - at);
        at = end + 1;
    }
    return parts;
}

/// Notes whose messages differ only in what they quote.
struct NoteKind {
    std::size_t count = 0; ///< of all together
    std::vector<std::string> quoted;

    bool joined() const {
        constexpr std::size_t kMany = 5; // fewer keep their places
        return quoted.size() > kMany;
    }

    /// Returns "(9 times; also 'b', 'c')".
    std::string text() const {
        constexpr std::size_t kShown = 8;
        std::string text = " (" + std::to_string(count) + " times";
        for (std::size_t k = 1; k < std::min(quoted.size(), kShown); ++k) {
            text += (k == 1 ? "; also " : ", ") + quoted[k];
        }
        return text + (quoted.size() > kShown ? " and others)" : ")");
    }
};

} // namespace

void ImportNotes::add(std::string_view code, const std::string &message, const std::string &file, std::string_view text,
                      std::size_t offset, std::size_t count) {
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
    entries_.push_back({std::string(code), message, count, file, place.line, place.column});
}

Diagnostics ImportNotes::diagnostics() const {
    std::map<std::tuple<std::string, std::string, std::string>, NoteKind> kinds;
    const auto kindOf = [&](const ImportNote &note, const Quoting &parts) -> NoteKind & {
        return kinds[{note.code, note.file, parts.frame}];
    };
    for (const ImportNote &note : entries_) {
        const Quoting parts = quotingOf(note.message);
        NoteKind &kind = kindOf(note, parts);
        kind.count += note.count;
        kind.quoted.push_back(parts.quoted);
    }
    Diagnostics list;
    for (const ImportNote &note : entries_) {
        const Quoting parts = quotingOf(note.message);
        const NoteKind &kind = kindOf(note, parts);
        if (kind.joined() && kind.quoted.front() != parts.quoted) {
            continue;
        }
        Diagnostic entry;
        entry.severity = Severity::Note;
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
