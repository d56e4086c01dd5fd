#include "core/files/common/repeated_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace forefront {

namespace {

Box2 boxOf(std::span<const Vec2> nodes) {
    Box2 box;
    std::for_each(nodes.begin(), nodes.end(), [&](Vec2 node) { box.add(node); });
    return box;
}

/// Returns true if the nodes of b, from node k on and with this step, are those of a. Both have the same number.
bool agree(std::span<const Vec2> a, std::span<const Vec2> b, std::size_t k, std::size_t step, double tolerance) {
    return std::all_of(a.begin(), a.end(), [&](Vec2 node) {
        const bool same = distance(node, b[k]) <= tolerance;
        k = (k + step) % b.size();
        return same;
    });
}

bool isSame(std::span<const Vec2> a, std::span<const Vec2> b, double tolerance) {
    for (std::size_t k = 0; k < b.size(); ++k) {
        if (agree(a, b, k, 1, tolerance) || agree(a, b, k, b.size() - 1, tolerance)) {
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<std::uint8_t> findRepeatedLoops(const std::vector<std::span<const Vec2>> &loops, double tolerance) {
    struct Known {
        std::size_t loop;
        Box2 box;
    };
    // By the number of nodes and the cell that holds the lower left corner of the box.
    std::map<std::tuple<std::size_t, double, double>, std::vector<Known>> known;
    const double cell = std::max(4.0 * tolerance, std::numeric_limits<double>::min());
    std::vector<std::uint8_t> repeated(loops.size(), 0);
    for (std::size_t k = 0; k < loops.size(); ++k) {
        const Box2 box = boxOf(loops[k]);
        const double column = std::floor(box.min.x / cell), row = std::floor(box.min.y / cell);
        const auto isOriginal = [&](const Known &other) {
            return distance(other.box.min, box.min) <= 2.0 * tolerance &&
                   distance(other.box.max, box.max) <= 2.0 * tolerance &&
                   isSame(loops[k], loops[other.loop], tolerance);
        };
        for (const double x : {column - 1.0, column, column + 1.0}) {
            for (const double y : {row - 1.0, row, row + 1.0}) {
                const auto found = known.find({loops[k].size(), x, y});
                if (found != known.end() && std::any_of(found->second.begin(), found->second.end(), isOriginal)) {
                    repeated[k] = 1;
                }
            }
        }
        if (repeated[k] == 0) {
            known[{loops[k].size(), column, row}].push_back({k, box});
        }
    }
    return repeated;
}

} // namespace forefront
