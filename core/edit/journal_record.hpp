#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace forefront {

/// First bytes of a recovery journal.
inline constexpr std::string_view kJournalMagic = "FFJOURN1";

enum class JournalRecord : std::uint8_t {
    Path = 1,  ///< where the document is saved, UTF-8; empty: never saved
    Whole = 2, ///< the text of the document
    Delta = 3, ///< the text as a change of the text before
    Saved = 4  ///< the document is what its file holds: nothing to recover
};

/// A record with its length and checksum, as appended to a journal: kind, 3 bytes 0, 4 bytes 0, length and checksum of
/// 8 bytes each (little-endian), payload.
std::string encodeRecord(JournalRecord kind, std::string_view payload);
/// Payload of a Delta: the lengths of the common beginning and end, and what stands between them now.
std::string encodeDelta(std::string_view before, std::string_view after);

/// What a journal says at its end.
struct JournalContent {
    std::string path;                ///< of the document
    std::optional<std::string> text; ///< newest text; none where there is nothing to recover
    std::size_t records = 0;         ///< sound ones
    std::size_t soundBytes = 0;      ///< what follows is cut off or spoilt
};

/// Reads as far as the journal is sound: a record cut off by a crash, or spoilt, ends it. No count in it is trusted.
JournalContent readJournal(std::string_view bytes);

} // namespace forefront
