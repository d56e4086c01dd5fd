#include "core/files/common/names.hpp"

#include "core/engine/base/letter_case.hpp"
#include "core/engine/domain/domain.hpp"

#include <algorithm>
#include <charconv>

namespace forefront {

namespace {

/// Returns the length of the well-formed UTF-8 character at `at`, or 0.
std::size_t characterLength(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t k) {
        return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U;
    };
    const unsigned lead = byte(0);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xc0U) != 0x80U) {
            return 0;
        }
    }
    const bool overlongOrBeyond = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xed && byte(1) > 0x9f) ||
                                  (lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) > 0x8f);
    return length > 2 && overlongOrBeyond ? 0 : length;
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

} // namespace

std::string validUtf8(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = characterLength(text, at);
        result += length > 0 ? text.substr(at, length) : std::string_view("\xef\xbf\xbd");
        at += std::max<std::size_t>(length, 1);
    }
    return result;
}

std::string shortened(const std::string &text, std::size_t maximum) {
    if (text.size() <= maximum) {
        return text;
    }
    std::size_t size = maximum;
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80U) {
        --size;
    }
    return text.substr(0, size);
}

std::string cleanName(std::string_view text) {
    constexpr std::size_t kMaximum = 200;
    std::string name = validUtf8(text);
    std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    const std::size_t begin = name.find_first_not_of(' ');
    if (begin == std::string::npos) {
        return {};
    }
    name = shortened(name.substr(begin), kMaximum);
    name.erase(name.find_last_not_of(' ') + 1);
    return name;
}

std::string listed(const std::vector<std::string> &names, std::size_t maximum) {
    std::string list;
    for (std::size_t k = 0; k < std::min(names.size(), maximum); ++k) {
        list += (k > 0 ? ", '" : "'") + cleanName(names[k]) + '\'';
    }
    return list + (names.size() > maximum ? " and " + std::to_string(names.size() - maximum) + " more" : "");
}

std::string asIdentifier(std::string_view name, std::size_t maximum) {
    std::string result;
    for (std::size_t at = 0; at < name.size();) {
        const char c = name[at];
        result += isLetter(c) || (c >= '0' && c <= '9') ? c : '_';
        at += std::max<std::size_t>(characterLength(name, at), 1);
    }
    if (result.empty() || !isLetter(result.front())) {
        result.insert(0, "n_");
    }
    return result.substr(0, maximum);
}

std::string asQuotable(std::string_view name, std::size_t maximum) {
    std::string result = validUtf8(name);
    for (char &c : result) {
        c = c == '"' ? '\'' : static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return shortened(result, maximum);
}

std::string percentEncoded(std::string_view name, std::string_view others) {
    constexpr std::string_view kHex = "0123456789ABCDEF";
    std::string text;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < ' ' || byte > '~' || c == '%' || c == '"' || others.find(c) != std::string_view::npos) {
            text += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
        } else {
            text += c;
        }
    }
    return text;
}

std::string percentDecoded(std::string_view text) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                      : -1;
    };
    std::string name;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '%' && k + 2 < text.size() && digit(text[k + 1]) >= 0 && digit(text[k + 2]) >= 0) {
            name += static_cast<char>(digit(text[k + 1]) * 16 + digit(text[k + 2]));
            k += 2;
        } else {
            name += text[k];
        }
    }
    return name;
}

bool UniqueNames::taken(const std::string &name) const {
    return taken_.count(lowerCase(name)) > 0;
}

std::string UniqueNames::claim(const std::string &name, std::size_t maximum) {
    std::string candidate = shortened(name, maximum);
    for (int number = 2; !taken_.insert(lowerCase(candidate)).second; ++number) {
        const std::string ending = '_' + std::to_string(number);
        candidate = shortened(name, maximum - ending.size()) + ending;
    }
    return candidate;
}

TagList tagsOf(const MeshView &mesh) {
    TagList tags;
    for (const TaggedEdge &edge : mesh.edges) {
        tags.edges.try_emplace(edge.tag);
    }
    for (const TaggedNode &point : mesh.points) {
        tags.points.try_emplace(point.tag);
    }
    for (const MeshView::Block &block : mesh.blocks()) {
        for (std::size_t k = 0; k < block.size(); ++k) {
            if (k == 0 || block.region(k) != block.region(k - 1)) { // most neighbours have the same
                tags.regions.try_emplace(block.region(k));
            }
        }
    }
    for (auto &[tag, name] : tags.edges) {
        name = boundaryName(mesh.boundaryNames, tag);
    }
    for (auto &[tag, name] : tags.points) {
        name = boundaryName(mesh.boundaryNames, tag);
    }
    for (auto &[tag, name] : tags.regions) {
        name = regionName(mesh.regionNames, tag);
    }
    return tags;
}

FileNames identifiersOf(const TagList &tags, UniqueNames &unique) {
    FileNames names;
    const auto add = [&](const auto &from, auto &to, const std::string &ending) {
        for (const auto &[tag, name] : from) {
            std::string identifier = asIdentifier(name);
            if (unique.taken(identifier)) {
                identifier = asIdentifier(name, 80 - ending.size()) + ending;
            }
            to.emplace(tag, unique.claim(identifier));
        }
    };
    add(tags.edges, names.edges, "");
    add(tags.regions, names.regions, "_region");
    add(tags.points, names.points, "_point");
    return names;
}

Diagnostics noteChangedNames(const TagList &tags, const FileNames &written) {
    constexpr std::size_t kListed = 8;
    std::string list;
    std::size_t changes = 0;
    const auto compare = [&](const char *kind, const auto &names, const auto &inFile) {
        for (const auto &[tag, name] : inFile) {
            const std::string &given = names.at(tag);
            if (given != name && changes++ < kListed) {
                list += (list.empty() ? "" : ", ") + std::string(kind) + " '" + asQuotable(given) + "' is " + name;
            }
        }
    };
    compare("boundary", tags.edges, written.edges);
    compare("region", tags.regions, written.regions);
    compare("point", tags.points, written.points);
    if (changes == 0) {
        return {};
    }
    if (changes > kListed) {
        list += " and " + std::to_string(changes - kListed) + " more";
    }
    Diagnostic note;
    note.severity = Severity::Note;
    note.code = "changed-names";
    note.message = "names changed to fit the format: " + list;
    return {note};
}

void addName(std::map<std::int32_t, std::string> &names, std::int32_t tag, const std::string &name, bool region) {
    const std::string clean = cleanName(name);
    if (tag >= 1 && !clean.empty() && clean != (region ? regionName({}, tag) : boundaryName({}, tag))) {
        names.emplace(tag, clean);
    }
}

void writeNameComments(const TagList &tags, std::string_view prefix, TextWriter &out) {
    auto boundaries = tags.points;
    boundaries.insert(tags.edges.begin(), tags.edges.end());
    for (const auto &[tag, name] : boundaries) {
        out << prefix << " boundary " << tag << " \"" << percentEncoded(validUtf8(name)) << "\"\n";
    }
    for (const auto &[tag, name] : tags.regions) {
        out << prefix << " region " << tag << " \"" << percentEncoded(validUtf8(name)) << "\"\n";
    }
}

TagNames readNameComments(std::string_view text, std::string_view prefix) {
    TagNames names;
    for (const bool region : {false, true}) {
        const std::string start = std::string(prefix) + (region ? " region " : " boundary ");
        for (std::size_t at = text.find(start); at != std::string_view::npos; at = text.find(start, at + 1)) {
            if (at > 0 && text[at - 1] != '\n') {
                continue;
            }
            std::string_view line = text.substr(at + start.size());
            line = line.substr(0, line.find('\n'));
            std::int32_t tag = 0;
            const auto [end, problem] = std::from_chars(line.data(), line.data() + line.size(), tag);
            const std::size_t open = line.find('"');
            const std::size_t close = line.rfind('"');
            if (problem == std::errc{} && open < close) {
                addName(region ? names.region : names.boundary, tag,
                        percentDecoded(line.substr(open + 1, close - open - 1)), region);
            }
        }
    }
    return names;
}

} // namespace forefront
