#include "core/drawing_files/geojson/map_reader.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>

// Notes on the parts of a map that are not used.

namespace forefront {

namespace {

bool isAmong(std::string_view key, std::initializer_list<std::string_view> known) {
    return std::find(known.begin(), known.end(), key) != known.end();
}

} // namespace

void MapReader::Unused::add(const std::string &key, std::size_t offset) {
    keys.insert(key);
    first = count++ == 0 ? offset : first;
}

void MapReader::noteMembers(const JsonValue &object, std::initializer_list<std::string_view> known) {
    for (auto member = object.begin(); member != object.end(); ++member) {
        const std::string key = member.key();
        if (!isAmong(key, known) && !isAmong(key, {"type", "bbox", "crs"})) {
            members_.add(key, member.keyValue().offset());
        }
    }
}

void MapReader::noteWithoutGeometry(const JsonValue &feature) {
    source_.note("no-geometry", "features without a geometry are ignored", feature.offset());
}

/// Reports members that are not used, once for the whole file.
void MapReader::noteUnused() const {
    if (heights_.count > 0) {
        source_.note("height", "third coordinates are ignored: the domain is planar", heights_.first, heights_.count);
    }
    note(properties_, "properties",
         names_.source() == "tag"
             ? std::string("properties other than \"tag\" are ignored: ")
             : "properties other than \"" + cleanName(names_.source()) + "\" and \"tag\" are ignored: ",
         !named_ && names_.offersText() ? "; --name-property takes names from one of them" : "");
    note(members_, "members", "members that have no meaning here are ignored: ");
}

void MapReader::note(const Unused &unused, const char *code, const std::string &start, const std::string &end) const {
    if (unused.count == 0) {
        return;
    }
    constexpr std::size_t kShown = 8;
    const std::vector<std::string> keys(unused.keys.begin(), unused.keys.end());
    source_.note(code, start + listed(keys, kShown) + end, unused.first, unused.count);
}

} // namespace forefront
