#include "core/drawing/recovery/journal_record.hpp"

#include "core/engine/base/hash.hpp"

#include <algorithm>

namespace forefront {
namespace {

constexpr std::size_t kHeader = 24;

void putWord(std::string &out, std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) {
        out += static_cast<char>(static_cast<unsigned char>(word >> shift));
    }
}

std::uint64_t word(std::string_view bytes, std::size_t at) {
    std::uint64_t value = 0;
    const std::size_t n = std::min<std::size_t>(8, bytes.size() - at);
    for (std::size_t k = 0; k < n; ++k) {
        value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
    }
    return value;
}

std::uint64_t checksum(std::uint64_t kind, std::string_view payload) {
    Hash64 hash;
    hash.add(kind);
    hash.add(static_cast<std::uint64_t>(payload.size()));
    for (std::size_t at = 0; at < payload.size(); at += 8) {
        hash.add(word(payload, at));
    }
    return hash.value();
}

/// Returns false if the delta does not fit the text.
bool applyDelta(std::string &text, std::string_view payload) {
    if (payload.size() < 16) {
        return false;
    }
    const std::uint64_t head = word(payload, 0), tail = word(payload, 8);
    if (head > text.size() || tail > text.size() - head) {
        return false;
    }
    text.replace(head, text.size() - head - tail, payload.substr(16));
    return true;
}

} // namespace

std::string encodeRecord(JournalRecord kind, std::string_view payload) {
    std::string record;
    record.reserve(kHeader + payload.size());
    putWord(record, static_cast<std::uint64_t>(kind));
    putWord(record, payload.size());
    putWord(record, checksum(static_cast<std::uint64_t>(kind), payload));
    record += payload;
    return record;
}

std::string encodeHash(std::uint64_t hash) {
    std::string payload;
    putWord(payload, hash);
    return payload;
}

std::string encodeDelta(std::string_view before, std::string_view after) {
    const std::size_t common = std::min(before.size(), after.size());
    const auto head = static_cast<std::size_t>(
        std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(common), after.begin()).first -
        before.begin());
    const auto tail = static_cast<std::size_t>(
        std::mismatch(before.rbegin(), before.rbegin() + static_cast<std::ptrdiff_t>(common - head), after.rbegin())
            .first -
        before.rbegin());
    std::string delta;
    putWord(delta, head);
    putWord(delta, tail);
    delta += after.substr(head, after.size() - head - tail);
    return delta;
}

JournalContent readJournal(std::string_view bytes) {
    JournalContent content;
    if (!bytes.starts_with(kJournalMagic)) {
        return content;
    }
    std::string text;
    bool known = false, saved = true;
    std::size_t at = kJournalMagic.size();
    content.validBytes = at;
    while (bytes.size() - at >= kHeader) {
        const std::uint64_t kind = word(bytes, at), length = word(bytes, at + 8);
        if (length > bytes.size() - at - kHeader) {
            break;
        }
        const std::string_view payload = bytes.substr(at + kHeader, length);
        if (word(bytes, at + 16) != checksum(kind, payload)) {
            break;
        }
        bool sound = true;
        switch (kind) {
        case static_cast<std::uint64_t>(JournalRecord::Path):
            content.path = payload;
            break;
        case static_cast<std::uint64_t>(JournalRecord::Title):
            content.title = payload;
            break;
        case static_cast<std::uint64_t>(JournalRecord::SavedHash):
            content.savedHash = word(payload, 0);
            break;
        case static_cast<std::uint64_t>(JournalRecord::FullText):
            text = payload;
            known = true;
            saved = false;
            break;
        case static_cast<std::uint64_t>(JournalRecord::Delta):
            sound = known && applyDelta(text, payload);
            saved = false;
            break;
        case static_cast<std::uint64_t>(JournalRecord::Saved):
            saved = true;
            break;
        default:
            sound = false;
        }
        if (!sound) {
            break;
        }
        at += kHeader + length;
        content.validBytes = at;
        ++content.records;
    }
    if (known && !saved) {
        content.text = std::move(text);
    }
    return content;
}

} // namespace forefront
