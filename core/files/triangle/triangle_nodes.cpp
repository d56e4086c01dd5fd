#include "core/files/triangle/triangle_nodes.hpp"

#include "core/files/common/planar_mesh.hpp"

#include <limits>

namespace forefront {

bool TriangleNodes::read(TextScanner &scanner, bool mayBeEmpty) {
    TextScanner line = scanner;
    if (!scanner.nextLine(line)) {
        return scanner.fail(scanner.offset(), "bad-syntax", "expected the number of nodes, found the end of the file");
    }
    std::size_t count = 0;
    std::int64_t dimension = 2, markerCount = 0;
    TextScanner whole = scanner.part(line.offset(), scanner.source().text.size());
    if (!whole.count(count, 6, {"the number of nodes"})) {
        return scanner.fail(whole);
    }
    line.seek(whole.offset());
    if (!line.integer(dimension, 2, 2, {"the dimension"}) ||
        (!line.atEnd() && !line.integer(attributes, 0, 1000, {"the number of attributes"})) ||
        (!line.atEnd() && !line.integer(markerCount, 0, 1, {"the number of markers"}))) {
        return scanner.fail(line);
    }
    if (count == 0 && !mayBeEmpty) {
        return scanner.fail(line.offset(), "bad-count", "the file holds no nodes");
    }
    places.reserve(count);
    markers.assign(count, 1);
    table.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        if (!scanner.nextLine(line)) {
            return scanner.fail(scanner.offset(), "bad-syntax",
                                "expected node " + std::to_string(k + 1) + " of " + std::to_string(count) +
                                    ", found the end of the file");
        }
        if (scanner.source().origin != nullptr) {
            offsets.push_back(line.offset());
        }
        std::int64_t number = 0;
        Vec2 place;
        double unused = 0.0;
        if (!line.integer(number, 0, std::numeric_limits<std::int32_t>::max(), {"the number of node", k + 1})) {
            return scanner.fail(line);
        }
        const Expect expect{"the coordinates of node", static_cast<std::uint64_t>(number)};
        if (!line.real(place.x, expect) || !line.real(place.y, expect)) {
            return scanner.fail(line);
        }
        for (std::int64_t a = 0; a < attributes; ++a) {
            if (!line.real(unused, {"an attribute of node", static_cast<std::uint64_t>(number)})) {
                return scanner.fail(line);
            }
        }
        if (markerCount == 1 && !line.atEnd() &&
            !readTag(line, markers[k], {"the marker of node", static_cast<std::uint64_t>(number)})) {
            return scanner.fail(line);
        }
        places.push_back(place);
        table.add(number);
    }
    if (table.finish() != kNoIndex) {
        return scanner.fail(line.offset(), "duplicate-node", "two nodes have the same number");
    }
    return true;
}

} // namespace forefront
