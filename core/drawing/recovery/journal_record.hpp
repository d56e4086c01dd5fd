#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// The first bytes of a recovery journal.
inline constexpr std::string_view kJournalMagic = "FFJOURN1";

/// Kind of a journal record.
enum class JournalRecord : std::uint8_t {
    Path = 1,     ///< path of the saved document, UTF-8; empty: never saved
    FullText = 2, ///< the text of the document
    Delta = 3,    ///< change of the previous text
    Saved = 4,    ///< the document is saved: nothing to recover
    Title = 5,    ///< title of the document, UTF-8, for one without a path
    SavedHash = 6 ///< hash of the file at the path when it was last read or saved: 8 bytes, little-endian; 0: unknown
};

/// Encodes a record for a journal: kind, 7 zero bytes, length and checksum of 8 bytes each (little-endian), payload.
std::string encodeRecord(JournalRecord kind, std::string_view payload);
/// Encodes the payload of a SavedHash.
std::string encodeHash(std::uint64_t hash);
/// Encodes the payload of a Delta: the lengths of the common beginning and end, and the new text between them.
std::string encodeDelta(std::string_view before, std::string_view after);

/// The state at the end of a journal.
struct JournalContent {
    std::string path, title;         ///< of the document
    std::uint64_t savedHash = 0;     ///< of the file at `path`; 0: unknown
    std::optional<std::string> text; ///< newest text; empty if there is nothing to recover
    std::size_t records = 0;         ///< number of valid records
    std::size_t validBytes = 0;      ///< length of the valid part; the rest is truncated or corrupt
};

/// Reads a journal up to the first record that is truncated by a crash or corrupt. Trusts no count in the file.
JournalContent readJournal(std::string_view bytes);

} // namespace forefront
