#include "core/io/source/import_notes.hpp"

#include "core/io/source/text_place.hpp"

#include <algorithm>

namespace forefront {

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
    Diagnostics list;
    for (const ImportNote &note : entries_) {
        Diagnostic entry;
        entry.severity = Severity::Note;
        entry.code = note.code;
        entry.message = note.message + (note.count > 1 ? " (" + std::to_string(note.count) + " times)" : "");
        entry.file = note.file;
        entry.line = note.line;
        entry.column = note.column;
        list.push_back(std::move(entry));
    }
    return list;
}

} // namespace forefront
