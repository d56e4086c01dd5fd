#include "core/drawing/commands/shared_segments.hpp"

#include "core/drawing/joints/joint_index.hpp"
#include "core/drawing/picking/selected_handles.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// A node that a command inserted into a path or removed from it, between two others.
struct ListedNode {
    std::uint32_t shape = 0;
    Vec2 at;
    std::optional<Vec2> previous, next; ///< none at the end of an open path
};

/// Returns the nodes of the longer list that the shorter one lacks; none unless the shorter one is the rest of it.
std::vector<ListedNode> missing(const Shape &longer, const std::vector<Vec2> &shorter) {
    std::vector<ListedNode> list;
    const std::vector<Vec2> &nodes = longer.nodes;
    const std::size_t n = nodes.size();
    const bool closed = isClosed(longer);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < n; ++k) {
        if (kept < shorter.size() && nodes[k] == shorter[kept]) {
            ++kept;
            continue;
        }
        const bool first = k == 0 && !closed, last = k + 1 == n && !closed;
        list.push_back({longer.id, nodes[k], first ? std::nullopt : std::optional(nodes[(k + n - 1) % n]),
                        last ? std::nullopt : std::optional(nodes[(k + 1) % n])});
    }
    return kept == shorter.size() ? list : std::vector<ListedNode>();
}

Diagnostics joinedNode(Vec2 at, const Shape &other) {
    return error("joined-node", "the node at " + placeText(at) + " is joined with " + displayName(other),
                 "detach it first, or delete the other segments at it");
}

/// Inserts and removes nodes of segments that paths share.
class SharedSegments {
  public:
    SharedSegments(const JointIndex &index, Document after)
        : before_(index.document()), document_(std::move(after)), tolerance_(index.tolerance()) {}

    Result<Document> run() {
        std::vector<ListedNode> inserted, removed;
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const std::shared_ptr<const Shape> &shape = document_.shapes[s];
            if (s < before_.shapes.size() && before_.shapes[s] == shape) {
                continue; // without a look into it
            }
            const Shape *const old = findShape(before_, shape->id);
            if (old == nullptr || old == shape.get() || !isPath(*old) || !isPath(*shape) ||
                isClosed(*old) != isClosed(*shape)) {
                continue;
            }
            const std::vector<ListedNode> more = missing(*shape, old->nodes), fewer = missing(*old, shape->nodes);
            inserted.insert(inserted.end(), more.begin(), more.end());
            removed.insert(removed.end(), fewer.begin(), fewer.end());
        }
        for (const ListedNode &node : inserted) {
            if (Status status = insertInto(node); !status.empty()) {
                return status;
            }
        }
        for (const ListedNode &node : removed) {
            if (hasNewShapeAt(node.at)) { // the path was divided there
                continue;
            }
            if (Status status = removeFrom(node); !status.empty()) {
                return status;
            }
        }
        return std::move(document_);
    }

  private:
    bool same(Vec2 a, Vec2 b) const { return distance(a, b) <= tolerance_; }
    bool same(const std::optional<Vec2> &a, Vec2 b) const { return a && same(*a, b); }

    /// Returns true if a shape that the command has added has a node at a place.
    bool hasNewShapeAt(Vec2 at) const {
        return std::any_of(document_.shapes.begin(), document_.shapes.end(), [&](const auto &shape) {
            return findShape(before_, shape->id) == nullptr &&
                   std::any_of(shape->nodes.begin(), shape->nodes.end(), [&](Vec2 node) { return same(node, at); });
        });
    }

    Status insertInto(const ListedNode &node) {
        for (std::size_t s = 0; s < document_.shapes.size(); ++s) {
            const std::shared_ptr<const Shape> shape = document_.shapes[s];
            if (shape->id == node.shape || !isPath(*shape)) {
                continue;
            }
            const std::vector<Vec2> &nodes = shape->nodes;
            const std::size_t count = isClosed(*shape) ? nodes.size() : nodes.size() - 1;
            for (std::uint32_t k = 0; k < count; ++k) {
                const Vec2 a = nodes[k], b = nodes[(k + 1) % nodes.size()];
                if ((same(node.previous, a) && same(node.next, b)) || (same(node.previous, b) && same(node.next, a))) {
                    Result<Document> next = insertNode(document_, {shape->id, k}, node.at);
                    if (!next) {
                        return next.faults();
                    }
                    document_ = *std::move(next);
                    break;
                }
            }
        }
        return {};
    }

    Status removeFrom(const ListedNode &removed) {
        Selection joined;
        for (const auto &shape : document_.shapes) {
            if (shape->id == removed.shape || !canJoin(*shape)) {
                continue;
            }
            const std::vector<Vec2> nodes = handlesOf(*shape);
            const std::size_t n = nodes.size();
            for (std::uint32_t k = 0; k < n; ++k) {
                if (!same(nodes[k], removed.at)) {
                    continue;
                }
                const bool end = !isClosed(*shape) && (k == 0 || k + 1 == n);
                const Vec2 previous = nodes[(k + n - 1) % n], next = nodes[(k + 1) % n];
                const bool shared = isPath(*shape) && !end &&
                                    ((same(removed.previous, previous) && same(removed.next, next)) ||
                                     (same(removed.previous, next) && same(removed.next, previous)));
                if (!shared || shape->locked) {
                    return joinedNode(removed.at, *shape);
                }
                joined.nodes.insert({shape->id, k});
            }
        }
        if (!joined.empty()) {
            document_ = deleteSelection(document_, joined);
        }
        return {};
    }

    const Document &before_;
    Document document_;
    double tolerance_;
};

} // namespace

Result<Document> editSharedSegments(const JointIndex &index, Document after) {
    return SharedSegments(index, std::move(after)).run();
}

Result<Document> deleteUnlessJoined(const JointIndex &index, const Selection &selection) {
    const Document &document = index.document();
    Document next = deleteSelection(document, selection);
    std::map<std::uint32_t, std::vector<std::uint32_t>> gone; // selected nodes by shape
    for (const NodeRef &ref : selection.nodes) {
        if (!selection.shapes.contains(ref.shape) && findShape(next, ref.shape) == nullptr) {
            gone[ref.shape].push_back(ref.node);
        }
    }
    for (const auto &entry : gone) {
        const std::uint32_t id = entry.first;
        const std::vector<std::uint32_t> &nodes = entry.second;
        const Shape *const shape = findShape(document, id);
        const std::vector<Vec2> places = shape != nullptr ? handlesOf(*shape) : std::vector<Vec2>();
        if (nodes.size() >= places.size()) {
            continue; // all of it is selected
        }
        for (const std::uint32_t node : nodes) {
            if (node >= places.size()) {
                continue;
            }
            const Shape *joined = nullptr;
            index.handlesAt(places[node], [&](const JointHandle &handle) {
                const Shape &other = *document.shapes[handle.shape];
                joined = other.id != id && findShape(next, other.id) != nullptr ? &other : joined;
            });
            if (joined != nullptr) {
                return joinedNode(places[node], *joined);
            }
        }
    }
    return next;
}

} // namespace forefront
