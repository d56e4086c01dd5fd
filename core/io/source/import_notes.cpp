#include "core/io/source/import_notes.hpp"

#include "core/io/source/text_place.hpp"

#include <algorithm>

namespace forefront {

namespace {

/// A message without what it quotes, and that: 'a', 'b'.
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

/// Keeps what a message quotes unless an earlier one of its kind did.
void addQuoted(ImportNote &note, const std::string &quoted) {
    constexpr std::size_t kMaxAlso = 3;
    const bool known = std::find(note.also.begin(), note.also.end(), quoted) != note.also.end();
    if (!known && note.also.size() < kMaxAlso) {
        note.also.push_back(quoted);
    } else if (!known) {
        note.alsoMore = true;
    }
}

/// Returns "(3 times; also 'b', 'c')".
std::string countOf(const ImportNote &note) {
    std::string text = " (" + std::to_string(note.count) + " times";
    for (std::size_t i = 0; i < note.also.size(); ++i) {
        text += (i == 0 ? "; also " : ", ") + note.also[i];
    }
    return text + (note.alsoMore ? " and others)" : ")");
}

} // namespace

void ImportNotes::add(std::string_view code, const std::string &message, const std::string &file, std::string_view text,
                      std::size_t offset, std::size_t count) {
    constexpr std::size_t kMaxEntries = 200; // then, notes that differ in their message alone are counted together
    const bool full = entries_.size() >= kMaxEntries;
    const auto find = [&](const auto &matches) {
        return std::find_if(entries_.begin(), entries_.end(), [&](const ImportNote &note) {
            return note.code == code && note.file == file && matches(note.message);
        });
    };
    auto known = find([&](const std::string &other) { return full || other == message; });
    if (known == entries_.end()) {
        const Quoting own = quotingOf(message);
        known = find([&](const std::string &other) { return quotingOf(other).frame == own.frame; });
        if (known != entries_.end()) {
            addQuoted(*known, own.quoted);
        }
    }
    if (known != entries_.end()) {
        known->count += count;
        return;
    }
    const TextPlace place = placeOf(text, offset);
    entries_.push_back({std::string(code), message, {}, false, count, file, place.line, place.column});
}

Diagnostics ImportNotes::diagnostics() const {
    Diagnostics list;
    for (const ImportNote &note : entries_) {
        Diagnostic entry;
        entry.severity = Severity::Note;
        entry.code = note.code;
        entry.message = note.message + (note.count > 1 ? countOf(note) : "");
        entry.file = note.file;
        entry.line = note.line;
        entry.column = note.column;
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace forefront
