#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/files/gmsh/msh_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr std::int64_t kAnyPeriodic = std::numeric_limits<std::int64_t>::max();
constexpr std::int32_t kAnyPeriodicCurve = std::numeric_limits<std::int32_t>::max();

/// The tagged edges of a mesh by their first nodes.
class EdgesByNode {
  public:
    explicit EdgesByNode(const Mesh &mesh) : mesh_(mesh) {
        for (std::uint32_t k = 0; k < mesh.edges.size(); ++k) {
            order_.emplace_back(mesh.edges[k].a, k);
        }
        std::sort(order_.begin(), order_.end());
    }

    /// Returns the tag of the edges that join two of some nodes, ascending; 0 if there are none, or with several tags.
    std::int32_t partOf(const std::vector<NodeId> &nodes) const {
        std::int32_t tag = 0;
        for (const NodeId node : nodes) {
            for (auto at = std::lower_bound(order_.begin(), order_.end(), std::pair(node, std::uint32_t{0}));
                 at != order_.end() && at->first == node; ++at) {
                const TaggedEdge &edge = mesh_.edges[at->second];
                if (!std::binary_search(nodes.begin(), nodes.end(), edge.b)) {
                    continue;
                }
                if (tag != 0 && tag != edge.tag) {
                    return 0;
                }
                tag = edge.tag;
            }
        }
        return tag;
    }

  private:
    const Mesh &mesh_;
    std::vector<std::pair<NodeId, std::uint32_t>> order_; ///< first node and edge
};

/// Returns the motion that takes the first nodes of some pairs to the second ones; nothing if there is none.
std::optional<RigidMap> motionOf(const Mesh &mesh, const std::vector<NodePair> &pairs, double tolerance) {
    const auto first = [&](const NodePair &pair) { return mesh.nodes[index(pair.from)]; };
    const auto second = [&](const NodePair &pair) { return mesh.nodes[index(pair.to)]; };
    const auto fits = [&](const RigidMap &map) {
        return std::all_of(pairs.begin(), pairs.end(),
                           [&](const NodePair &pair) { return distance(map(first(pair)), second(pair)) <= tolerance; });
    };
    RigidMap map{1.0, 0.0, second(pairs.front()) - first(pairs.front())};
    map.shift.x = std::abs(map.shift.x) <= tolerance ? 0.0 : map.shift.x;
    map.shift.y = std::abs(map.shift.y) <= tolerance ? 0.0 : map.shift.y;
    if (fits(map)) {
        return map;
    }
    const NodePair &far = *std::max_element(pairs.begin(), pairs.end(), [&](const NodePair &p, const NodePair &q) {
        return distance(first(p), first(pairs.front())) < distance(first(q), first(pairs.front()));
    });
    const Vec2 arm = first(far) - first(pairs.front()), turned = second(far) - second(pairs.front());
    const double c = dot(arm, turned), s = cross(arm, turned), norm = std::hypot(c, s);
    if (!(norm > 0.0)) {
        return std::nullopt;
    }
    map = {c / norm, s / norm, {}};
    map.shift = second(pairs.front()) - map(first(pairs.front()));
    return fits(map) ? std::optional(map) : std::nullopt;
}

std::vector<NodeId> sortedNodes(const std::vector<NodePair> &pairs, NodeId NodePair::*which) {
    std::vector<NodeId> nodes;
    for (const NodePair &pair : pairs) {
        nodes.push_back(pair.*which);
    }
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

} // namespace

void MshFile::addPair(std::int64_t second, std::int64_t first) {
    const NodePair pair{NodeId{builder_.table.find(first)}, NodeId{builder_.table.find(second)}};
    if (pair.from == kNoNode || pair.to == kNoNode) {
        ++unknownPairs_;
    } else {
        periodic_.back().push_back(pair);
    }
}

bool MshFile::readPeriodicEntity() {
    std::int64_t dimension = 0, number = 0;
    std::size_t count = 0;
    if (!scanner_.integer(dimension, 0, 3, {"the dimension of a periodic entity"}) ||
        !scanner_.integer(number, -kAnyPeriodic, kAnyPeriodic, {"the tag of a periodic entity"}) ||
        !scanner_.integer(number, -kAnyPeriodic, kAnyPeriodic, {"the tag of its master"})) {
        return false;
    }
    if (version4_) {
        double value = 0.0;
        if (!scanner_.count(count, 2, {"the number of values of a matrix"})) {
            return false;
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (!scanner_.real(value, {"a value of a matrix"})) {
                return false;
            }
        }
    } else if (scanner_.peek() == "Affine") {
        scanner_.skipLine();
    }
    if (!scanner_.count(count, 4, {"the number of pairs of nodes"})) {
        return false;
    }
    const bool isCurve = dimension == 1;
    if (isCurve) {
        periodic_.emplace_back();
    }
    for (std::size_t k = 0; k < count; ++k) {
        std::int64_t second = 0, first = 0;
        if (!scanner_.integer(second, -kAnyPeriodic, kAnyPeriodic, {"a node of a periodic entity"}) ||
            !scanner_.integer(first, -kAnyPeriodic, kAnyPeriodic, {"a node of its master"})) {
            return false;
        }
        if (isCurve) {
            addPair(second, first);
        }
    }
    return true;
}

bool MshFile::readPeriodic() {
    if (binary_) {
        return readPeriodicBinary();
    }
    std::size_t count = 0;
    if (!scanner_.count(count, 8, {"the number of periodic entities"})) {
        return false;
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!readPeriodicEntity()) {
            return false;
        }
    }
    return true;
}

bool MshFile::readPeriodicBinary() {
    ByteScanner bytes(scanner_);
    std::size_t entities = 0;
    if (!bytes.count(entities, 3 * sizeof(std::int32_t), {"the number of periodic entities"})) {
        return false;
    }
    for (std::size_t k = 0; k < entities; ++k) {
        std::int32_t dimension = 0, number = 0;
        std::size_t values = 0, count = 0;
        if (!bytes.integer(dimension, 0, 3, {"the dimension of a periodic entity"}) ||
            !bytes.integer(number, -kAnyPeriodicCurve, kAnyPeriodicCurve, {"the tag of a periodic entity"}) ||
            !bytes.integer(number, -kAnyPeriodicCurve, kAnyPeriodicCurve, {"the tag of its master"}) ||
            !bytes.count(values, sizeof(double), {"the number of values of a matrix"}) ||
            bytes.block(values, sizeof(double), {"a matrix"}) == nullptr ||
            !bytes.count(count, 2 * sizeof(std::uint64_t), {"the number of pairs of nodes"})) {
            return false;
        }
        const bool isCurve = dimension == 1;
        if (isCurve) {
            periodic_.emplace_back();
        }
        for (std::size_t pair = 0; pair < count; ++pair) {
            std::int64_t second = 0, first = 0;
            if (!bytes.number(second, {"a node of a periodic entity"}) ||
                !bytes.number(first, {"a node of its master"})) {
                return false;
            }
            if (isCurve) {
                addPair(second, first);
            }
        }
    }
    return true;
}

void MshFile::findPeriodic(Mesh &mesh) {
    if (unknownPairs_ > 0) {
        scanner_.source().note("periodic",
                               "skipped " + countText(unknownPairs_, "pair") +
                                   " of periodic curves with a node that the file does not have",
                               0);
    }
    if (periodic_.empty()) {
        return;
    }
    const EdgesByNode edges(mesh);
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<NodePair>> links; // by the tags of both parts
    std::size_t ignored = 0;
    for (const std::vector<NodePair> &pairs : periodic_) {
        const std::int32_t from = edges.partOf(sortedNodes(pairs, &NodePair::from)),
                           to = edges.partOf(sortedNodes(pairs, &NodePair::to));
        if (from == 0 || to == 0 || from == to) {
            ++ignored;
            continue;
        }
        std::vector<NodePair> &all = links[{from, to}];
        all.insert(all.end(), pairs.begin(), pairs.end());
    }
    std::set<std::int32_t> used;
    const double tolerance = std::max(kPeriodicTolerance * mesh.bounds().diagonal(), 1e-300);
    for (const auto &[tags, pairs] : links) {
        const std::optional<RigidMap> map = motionOf(mesh, pairs, tolerance);
        if (map && !used.contains(tags.first) && !used.contains(tags.second)) {
            mesh.periodic.push_back({tags.first, tags.second, *map});
            if (verifyPeriodic(mesh).empty()) {
                used.insert({tags.first, tags.second});
                continue;
            }
            mesh.periodic.pop_back();
        }
        ++ignored;
    }
    if (ignored > 0) {
        scanner_.source().note("periodic",
                               "ignored " + countText(ignored, "pair") +
                                   " of periodic curves; expected whole boundary parts, each moved or turned once",
                               0);
    }
}

} // namespace forefront
