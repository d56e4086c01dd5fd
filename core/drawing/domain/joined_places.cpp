#include "core/drawing/domain/joined_places.hpp"

#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <tuple>

namespace forefront {
namespace {

/// A node of a shape.
struct HeldNode {
    Vec2 at;
    std::uint32_t shape = 0; ///< index into Document::shapes
    std::uint32_t order = 0; ///< in the drawing
    bool movable = false;    ///< its shape can have it elsewhere
};

/// Nodes at exactly the same place.
struct HeldPlace {
    Vec2 at;
    std::uint32_t order = 0;           ///< of the first one
    bool movable = true;               ///< all of them are
    std::vector<std::uint32_t> shapes; ///< ascending
};

bool isMovable(const Shape &shape) {
    return isPath(shape) || shape.is<PointForm>() ||
           (shape.is<RectangleForm>() && !(shape.as<RectangleForm>().radius > 0.0));
}

std::vector<HeldNode> nodesOf(const Document &document) {
    std::vector<HeldNode> nodes;
    for (std::uint32_t number = 0; number < document.shapes.size(); ++number) {
        const Shape &shape = *document.shapes[number];
        if (shape.construction) {
            continue;
        }
        const bool listed = isPath(shape) || shape.is<PointForm>(), movable = isMovable(shape);
        for (const Vec2 at : listed ? shape.nodes : outlineOf(shape).nodes) {
            nodes.push_back({at, number, static_cast<std::uint32_t>(nodes.size()), movable});
        }
    }
    return nodes;
}

std::vector<HeldPlace> placesOf(std::vector<HeldNode> nodes) {
    std::sort(nodes.begin(), nodes.end(), [](const HeldNode &a, const HeldNode &b) {
        return a.at != b.at ? comesBefore(a.at, b.at) : a.order < b.order;
    });
    std::vector<HeldPlace> places;
    for (const HeldNode &node : nodes) {
        if (places.empty() || places.back().at != node.at) {
            places.push_back({node.at, node.order, true, {}});
        }
        HeldPlace &place = places.back();
        place.movable = place.movable && node.movable;
        if (place.shapes.empty() || place.shapes.back() != node.shape) {
            place.shapes.push_back(node.shape);
        }
    }
    std::sort(places.begin(), places.end(), [](const HeldPlace &a, const HeldPlace &b) { return a.order < b.order; });
    return places;
}

/// Two places near each other, seen from the first one.
struct NearPlaces {
    std::uint32_t place = 0, other = 0;
    double apart = 0.0;

    friend bool operator<(const NearPlaces &a, const NearPlaces &b) {
        return std::tuple(a.place, a.apart, a.other) < std::tuple(b.place, b.apart, b.other);
    }
};

class PlaceJoiner {
  public:
    PlaceJoiner(std::vector<HeldPlace> places, double tolerance) : places_(std::move(places)), tolerance_(tolerance) {}

    /// Returns what becomes one, as pairs of a place and the place where it goes.
    std::vector<std::pair<Vec2, Vec2>> run() {
        findNear();
        joined_.assign(near_.empty() ? 0 : places_.size(), false);
        for (const NearPlaces &pair : near_) {
            if (!joined_[pair.place]) {
                joinFrom(pair.place);
            }
        }
        return std::move(moves_);
    }

  private:
    void findNear() {
        std::vector<Box2> boxes;
        boxes.reserve(places_.size());
        for (const HeldPlace &place : places_) {
            boxes.push_back({place.at, place.at});
        }
        BoxTree(boxes).joinSelf(tolerance_, [&](std::uint32_t a, std::uint32_t b) {
            const double apart = distance(places_[a].at, places_[b].at);
            if (a != b && apart <= tolerance_) {
                near_.push_back({a, b, apart});
                near_.push_back({b, a, apart});
            }
            return true;
        });
        std::sort(near_.begin(), near_.end());
    }

    std::span<const NearPlaces> nearTo(std::uint32_t place) const {
        const auto from = std::lower_bound(near_.begin(), near_.end(), NearPlaces{place, 0, 0.0});
        const auto to = std::lower_bound(from, near_.end(), NearPlaces{place + 1, 0, 0.0});
        return {from, to};
    }

    /// Joins a place with those near it, and near these.
    void joinFrom(std::uint32_t first) {
        std::vector<std::uint32_t> members{first};
        std::vector<std::uint32_t> shapes = places_[first].shapes;
        std::uint32_t target = first;
        joined_[first] = true;
        for (std::size_t k = 0; k < members.size(); ++k) {
            for (const NearPlaces &pair : nearTo(members[k])) {
                const HeldPlace &other = places_[pair.other];
                std::vector<std::uint32_t> all;
                std::set_union(shapes.begin(), shapes.end(), other.shapes.begin(), other.shapes.end(),
                               std::back_inserter(all));
                const bool apart = all.size() < shapes.size() + other.shapes.size(); // one shape has both places
                if (joined_[pair.other] || apart || (!other.movable && !places_[target].movable)) {
                    continue;
                }
                joined_[pair.other] = true;
                members.push_back(pair.other);
                shapes = std::move(all);
                target = other.movable ? target : pair.other;
            }
        }
        for (const std::uint32_t member : members) {
            if (member != target) {
                moves_.emplace_back(places_[member].at, places_[target].at);
            }
        }
    }

    std::vector<HeldPlace> places_; ///< in the order of the drawing
    double tolerance_;
    std::vector<NearPlaces> near_;
    std::vector<bool> joined_;
    std::vector<std::pair<Vec2, Vec2>> moves_;
};

} // namespace

JoinedPlaces::JoinedPlaces(const Document &document, double tolerance) {
    if (document.shapes.size() < 2 || !(tolerance > 0.0) || !std::isfinite(tolerance)) {
        return;
    }
    moves_ = PlaceJoiner(placesOf(nodesOf(document)), tolerance).run();
    std::sort(moves_.begin(), moves_.end(), [](const auto &a, const auto &b) { return comesBefore(a.first, b.first); });
}

Vec2 JoinedPlaces::of(Vec2 place) const {
    const auto found = std::lower_bound(moves_.begin(), moves_.end(), place,
                                        [](const auto &move, Vec2 p) { return comesBefore(move.first, p); });
    return found != moves_.end() && found->first == place ? found->second : place;
}

void JoinedPlaces::apply(Outline &outline) const {
    if (moves_.empty()) {
        return;
    }
    const Outline before = outline;
    for (Vec2 &node : outline.nodes) {
        node = of(node);
    }
    for (std::size_t k = 0; k < before.segmentCount(); ++k) {
        if (before.isCurved(k) && (before.from(k) != outline.from(k) || before.to(k) != outline.to(k))) {
            outline.curves[k] = joining(before.curves[k], outline.from(k), outline.to(k));
        }
    }
}

double JoinedPlaces::farthest() const {
    double farthest = 0.0;
    for (const auto &[from, to] : moves_) {
        farthest = std::max(farthest, distance(from, to));
    }
    return farthest;
}

} // namespace forefront
