#include "core/io/common/repeated_loops.hpp"

#include <algorithm>
#include <map>
#include <utility>

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
    std::multimap<std::pair<std::size_t, double>, Known> known; // by the number of nodes and the left end
    std::vector<std::uint8_t> repeated(loops.size(), 0);
    for (std::size_t k = 0; k < loops.size(); ++k) {
        const std::size_t count = loops[k].size();
        const Box2 box = boxOf(loops[k]);
        const auto end = known.upper_bound({count, box.min.x + tolerance});
        const auto original =
            std::find_if(known.lower_bound({count, box.min.x - tolerance}), end, [&](const auto &entry) {
                const Known &other = entry.second;
                return distance(other.box.min, box.min) <= 2.0 * tolerance &&
                       distance(other.box.max, box.max) <= 2.0 * tolerance &&
                       isSame(loops[k], loops[other.loop], tolerance);
            });
        if (original != end) {
            repeated[k] = 1;
        } else {
            known.insert({{count, box.min.x}, {k, box}});
        }
    }
    return repeated;
}

} // namespace forefront
