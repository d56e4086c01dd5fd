#include "core/drawing/arrangement/snapping/snapper.hpp"

#include "core/drawing/arrangement/snapping/cluster.hpp"
#include "core/drawing/arrangement/snapping/place_table.hpp"
#include "core/engine/base/ids.hpp"
#include "core/engine/base/key_order.hpp"
#include "core/engine/geometry/edge_meetings.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>

namespace forefront {

namespace {

constexpr std::size_t kMaxBoxesPerEdge = 64;
constexpr std::size_t kManySplit = 8; ///< a layer is built anew if more than 1/8 of its boxes are of split edges

} // namespace

Snapper::Snapper(std::span<const SnapLine> lines, std::span<const std::uint8_t> preferred, double radius)
    : lines_(lines), radius_(radius) {
    collectPlaces(preferred);
    makeEdges();
    chooseAxis();
}

void Snapper::collectPlaces(std::span<const std::uint8_t> preferred) {
    PlaceTable table(2 * lines_.size());
    ends_.reserve(2 * lines_.size());
    std::vector<std::uint8_t> stays;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        for (const Vec2 p : {lines_[i].a, lines_[i].b}) {
            ends_.push_back(table.indexOf(p, places_));
        }
        if (!preferred.empty() && preferred[i] != 0) {
            stays.resize(places_.size(), 0);
            stays[ends_[2 * i]] = 1;
        }
    }
    if (!stays.empty()) {
        stays.resize(places_.size(), 0);
    }
    givenPlaces_ = places_.size();
    leader_ = clusterPlaces(places_, stays, radius_);
}

void Snapper::makeEdges() {
    byEnds_.reserve(lines_.size());
    edges_.reserve(lines_.size());
    lineEdge_.reserve(lines_.size());
    double length = 0.0;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const std::uint32_t a = leader_[ends_[2 * i]], b = leader_[ends_[2 * i + 1]];
        const bool isPoint = ends_[2 * i] == ends_[2 * i + 1];
        if (isPoint) {
            halfEdge(a, a);
        }
        lineEdge_.push_back(a == b ? kNoIndex : halfEdge(a, b));
        length += distance(places_[a], places_[b]);
    }
    boxLength_ = edges_.empty() ? 0.0 : length / static_cast<double>(edges_.size());
}

/// Aligns the boxes with edges that mostly run in one slanted direction: boxes of close parallel edges overlap less.
void Snapper::chooseAxis() {
    constexpr double kMostly = 0.8, kSlant = 0.2;
    Vec2 sum; // sums directions with doubled angles, so that opposite ones agree
    double total = 0.0;
    for (const Edge &edge : edges_) {
        const Vec2 along = places_[edge.b] - places_[edge.a];
        const double size = length(along);
        if (size > 0.0) {
            sum += (1.0 / size) * Vec2{along.x * along.x - along.y * along.y, 2.0 * along.x * along.y};
            total += size;
        }
    }
    if (length(sum) > kMostly * total && std::fabs(sum.y) > kSlant * length(sum)) {
        const double angle = 0.5 * std::atan2(sum.y, sum.x);
        axis_ = {std::cos(angle), std::sin(angle)};
    }
}

/// Returns the half-edge between two nodes and makes it if there is none. Edges run from the end that comes first by x,
/// then y.
std::uint32_t Snapper::halfEdge(std::uint32_t from, std::uint32_t to) {
    const bool forth = from == to || comesBefore(places_[from], places_[to]);
    const std::uint32_t a = forth ? from : to, b = forth ? to : from;
    const auto [entry, added] = byEnds_.try_emplace(pairKey(a, b), static_cast<std::uint32_t>(edges_.size()));
    if (added) {
        edges_.push_back({a, b});
    }
    return 2 * entry->second + (forth ? 0U : 1U);
}

/// Puts edges into a tree. An edge that slants is covered by several boxes.
Snapper::Layer Snapper::layerOf(std::span<const std::uint32_t> edges) const {
    std::vector<Box2> boxes;
    Layer layer;
    for (const std::uint32_t e : edges) {
        const Vec2 a = turned(places_[edges_[e].a]), b = turned(places_[edges_[e].b]);
        const double slant = std::min(std::fabs(b.x - a.x), std::fabs(b.y - a.y));
        const double wanted = boxLength_ > 0.0 ? std::ceil(slant / boxLength_) : 1.0;
        const auto count = static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(kMaxBoxesPerEdge)));
        for (std::size_t k = 0; k < count; ++k) {
            const auto part = [&](std::size_t i) {
                return i == count ? b : lerp(a, b, static_cast<double>(i) / static_cast<double>(count));
            };
            boxes.push_back(boxOf(part(k), part(k + 1)));
            layer.edge.push_back(e);
        }
    }
    layer.tree = BoxTree(boxes);
    return layer;
}

/// Adds a layer of the edges from this one on, and builds layers anew in which many edges have been split since: each
/// would be found by all its parts.
void Snapper::index(std::uint32_t firstEdge) {
    std::vector<std::uint32_t> edges;
    for (Layer &layer : layers_) {
        const auto split = [&](std::uint32_t e) { return edges_[e].child != edges_[e].end; };
        const auto count = static_cast<std::size_t>(std::count_if(layer.edge.begin(), layer.edge.end(), split));
        if (kManySplit * count > layer.edge.size()) {
            edges.clear();
            std::copy_if(layer.edge.begin(), layer.edge.end(), std::back_inserter(edges),
                         [&](std::uint32_t e) { return !split(e) && (edges.empty() || edges.back() != e); });
            layer = layerOf(edges);
        }
    }
    edges.resize(edges_.size() - firstEdge);
    std::iota(edges.begin(), edges.end(), firstEdge);
    layers_.push_back(layerOf(edges));
}

/// Compares the edges of the last layer with one another and with all others. Returns false if asked to stop.
bool Snapper::findCuts(const std::stop_token &stop) {
    // Boxes of slanting edges are cut, and boxes are turned, with rounding; the radius is larger than that.
    const double reach = 2.0 * radius_;
    const Layer &fresh = layers_.back();
    std::size_t visits = 0;
    for (const Layer &layer : layers_) {
        const auto visit = [&](std::uint32_t mine, std::uint32_t theirs) {
            const std::uint32_t edge = fresh.edge[mine], other = layer.edge[theirs];
            if (edge != other && edges_[other].child == edges_[other].end) {
                compare(edge, other);
            }
            return ++visits % 65536 != 0 || !stop.stop_requested();
        };
        const bool finished =
            &layer == &fresh ? fresh.tree.joinSelf(reach, visit) : fresh.tree.join(layer.tree, reach, visit);
        if (!finished) {
            return false;
        }
    }
    return !stop.stop_requested();
}

void Snapper::compare(std::uint32_t edge, std::uint32_t other) {
    const Edge e = edges_[edge], f = edges_[other];
    if (apart(e, f) || apart(f, e)) {
        return;
    }
    bool near = false;
    for (const std::uint32_t node : {f.a, f.b}) {
        near = cutNear(edge, node) || near;
    }
    for (const std::uint32_t node : {e.a, e.b}) {
        near = cutNear(other, node) || near;
    }
    if (near || e.a == e.b || f.a == f.b) {
        return; // a crossing that is left shows up when the parts are compared
    }
    const Vec2 a = places_[e.a], b = places_[e.b], c = places_[f.a], d = places_[f.b];
    switch (meet(a, b, c, d)) {
    case SegmentMeeting::Crossing:
        addCrossing(edge, other);
        break;
    case SegmentMeeting::Touching:
    case SegmentMeeting::Overlapping:
        for (const std::uint32_t node : {f.a, f.b}) {
            if (node != e.a && node != e.b && onSegment(a, b, places_[node])) {
                addCut(edge, node);
            }
        }
        for (const std::uint32_t node : {e.a, e.b}) {
            if (node != f.a && node != f.b && onSegment(c, d, places_[node])) {
                addCut(other, node);
            }
        }
        break;
    case SegmentMeeting::Apart:
    case SegmentMeeting::SharedEnd:
        break;
    }
}

/// Returns true if the second edge is surely on one side of the line of the first, farther away than the radius.
bool Snapper::apart(const Edge &e, const Edge &f) const {
    constexpr double kFar = 2.0; // radii; far more than rounding adds to a distance
    const Vec2 a = places_[e.a], ab = places_[e.b] - a;
    const double c = cross(ab, places_[f.a] - a), d = cross(ab, places_[f.b] - a);
    const double nearest = std::min(std::fabs(c), std::fabs(d));
    return (c > 0.0) == (d > 0.0) && nearest * nearest > kFar * kFar * radius_ * radius_ * lengthSquared(ab);
}

/// Routes the edge through the node if the node is near its interior and both parts become shorter than the edge.
bool Snapper::cutNear(std::uint32_t edge, std::uint32_t node) {
    const Edge &e = edges_[edge];
    if (node == e.a || node == e.b) {
        return false;
    }
    const Vec2 a = places_[e.a], b = places_[e.b], p = places_[node];
    const Vec2 ab = b - a, ap = p - a;
    const double whole = lengthSquared(ab), along = dot(ap, ab), area = cross(ab, ap);
    if (!(along > 0.0 && along < whole && area * area <= radius_ * radius_ * whole) || lengthSquared(ap) >= whole ||
        distanceSquared(b, p) >= whole) {
        return false;
    }
    cuts_.push_back({edge, node, along});
    return true;
}

void Snapper::addCut(std::uint32_t edge, std::uint32_t node) {
    const Edge &e = edges_[edge];
    if (node != e.a && node != e.b) {
        const Vec2 a = places_[e.a];
        cuts_.push_back({edge, node, dot(places_[node] - a, places_[e.b] - a)});
    }
}

/// Handles two edges that cross, where no end of one is near the interior of the other.
void Snapper::addCrossing(std::uint32_t edge, std::uint32_t other) {
    const bool swapped =
        std::tuple(places_[edges_[other].a].x, places_[edges_[other].a].y, places_[edges_[other].b].x,
                   places_[edges_[other].b].y) < std::tuple(places_[edges_[edge].a].x, places_[edges_[edge].a].y,
                                                            places_[edges_[edge].b].x, places_[edges_[edge].b].y);
    const std::uint32_t first = swapped ? other : edge, second = swapped ? edge : other;
    const Edge e = edges_[first], f = edges_[second];
    const Vec2 at = crossingPoint(places_[e.a], places_[e.b], places_[f.a], places_[f.b]);
    std::uint32_t nearest = kNoIndex;
    for (const std::uint32_t node : {e.a, e.b, f.a, f.b}) {
        if (nearest == kNoIndex || distance(places_[node], at) < distance(places_[nearest], at)) {
            nearest = node;
        }
    }
    // Routing the other edge through the nearest of the four ends makes it shorter at any angle.
    const std::uint32_t through = distance(places_[nearest], at) <= radius_ ? nearest : nodeWithin(at);
    if (through == kNoIndex) {
        crossings_.push_back({at, first, second});
        return;
    }
    addCut(first, through);
    addCut(second, through);
}

/// Returns the nearest node of an edge within the radius, or kNoIndex.
std::uint32_t Snapper::nodeWithin(Vec2 at) {
    if (!grid_) { // many passes find no crossing
        grid_.emplace(2.0 * radius_, 2 * edges_.size());
    }
    for (; inGrid_ < edges_.size(); ++inGrid_) {
        for (const std::uint32_t node : {edges_[inGrid_].a, edges_[inGrid_].b}) {
            grid_->add(node, places_[node]);
        }
    }
    std::uint32_t best = kNoIndex;
    grid_->visitNear(at, [&](std::uint32_t node) {
        const double gap = distance(places_[node], at);
        const double limit = best == kNoIndex ? radius_ : distance(places_[best], at);
        if (gap < limit || (gap == limit && (best == kNoIndex || comesBefore(places_[node], places_[best])))) {
            best = node;
        }
    });
    return best;
}

/// Makes nodes where edges cross far from any node, only one where several crossings are close together.
void Snapper::addCrossings() {
    if (crossings_.empty()) {
        return;
    }
    std::vector<Vec2> distinct;
    PlaceTable table(crossings_.size());
    std::vector<std::uint32_t> place;
    for (const Crossing &crossing : crossings_) {
        place.push_back(table.indexOf(crossing.at, distinct));
    }
    const std::vector<std::uint32_t> leader = clusterPlaces(distinct, {}, radius_);
    std::vector<std::uint32_t> node(distinct.size(), kNoIndex);
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
        std::uint32_t &made = node[leader[place[i]]];
        if (made == kNoIndex) {
            made = static_cast<std::uint32_t>(places_.size());
            places_.push_back(distinct[leader[place[i]]]);
        }
        addCut(crossings_[i].first, made);
        addCut(crossings_[i].second, made);
    }
    crossings_.clear();
}

void Snapper::splitEdges() {
    std::vector<std::uint64_t> keys;
    keys.reserve(cuts_.size());
    for (const Cut &cut : cuts_) {
        keys.push_back(cut.edge);
    }
    const std::vector<std::uint32_t> order = orderByKeys(keys);
    std::vector<Cut> ofEdge;
    for (std::size_t i = 0; i < order.size();) {
        ofEdge.clear();
        const std::uint32_t edge = cuts_[order[i]].edge;
        for (; i < order.size() && cuts_[order[i]].edge == edge; ++i) {
            ofEdge.push_back(cuts_[order[i]]);
        }
        std::sort(ofEdge.begin(), ofEdge.end(), [&](const Cut &s, const Cut &t) {
            return s.along != t.along ? s.along < t.along
                                      : s.node != t.node && comesBefore(places_[s.node], places_[t.node]);
        });
        const auto sameNode = [](const Cut &s, const Cut &t) { return s.node == t.node; };
        ofEdge.erase(std::unique(ofEdge.begin(), ofEdge.end(), sameNode), ofEdge.end());
        split(edge, ofEdge);
    }
    cuts_.clear();
}

/// Splits at all nodes at once if that makes every part shorter, otherwise at the nearest node alone.
void Snapper::split(std::uint32_t edge, std::vector<Cut> &cuts) {
    if (cuts.size() > 1 && !shortens(edge, cuts)) {
        Cut nearest = cuts.front();
        for (const Cut &cut : cuts) {
            const double gapHere = gap(edge, cut.node), smallest = gap(edge, nearest.node);
            if (gapHere < smallest || (gapHere == smallest && comesBefore(places_[cut.node], places_[nearest.node]))) {
                nearest = cut;
            }
        }
        cuts.assign(1, nearest);
    }
    const Edge whole = edges_[edge];
    const auto firstChild = static_cast<std::uint32_t>(children_.size());
    std::uint32_t from = whole.a;
    for (const Cut &cut : cuts) {
        children_.push_back(halfEdge(from, cut.node));
        from = cut.node;
    }
    children_.push_back(halfEdge(from, whole.b));
    edges_[edge].child = firstChild;
    edges_[edge].end = static_cast<std::uint32_t>(children_.size());
}

bool Snapper::shortens(std::uint32_t edge, const std::vector<Cut> &cuts) const {
    const Edge &e = edges_[edge];
    const double whole = distanceSquared(places_[e.a], places_[e.b]);
    std::uint32_t from = e.a;
    for (const Cut &cut : cuts) {
        if (distanceSquared(places_[from], places_[cut.node]) >= whole) {
            return false;
        }
        from = cut.node;
    }
    return distanceSquared(places_[from], places_[e.b]) < whole;
}

/// Returns the distance of a node from the line of an edge.
double Snapper::gap(std::uint32_t edge, std::uint32_t node) const {
    const Vec2 a = places_[edges_[edge].a], ab = places_[edges_[edge].b] - a;
    return std::fabs(cross(ab, places_[node] - a)) / length(ab);
}

SnappedLines Snapper::run(const std::stop_token &stop) {
    bool finished = true;
    for (std::uint32_t fresh = 0; fresh < edges_.size() && finished;) {
        index(fresh);
        const auto end = static_cast<std::uint32_t>(edges_.size());
        finished = findCuts(stop);
        addCrossings();
        splitEdges();
        fresh = end;
    }
    SnappedLines result = collect();
    result.passes = 1;
    result.finished = finished;
    return result;
}

SnappedLines Snapper::collect() const {
    SnappedLines result;
    result.nodes = places_;
    result.crossing.assign(places_.size(), 0);
    std::fill(result.crossing.begin() + static_cast<std::ptrdiff_t>(givenPlaces_), result.crossing.end(), 1);
    std::vector<std::uint32_t> renumbered(edges_.size(), kNoIndex);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (edges_[e].child == edges_[e].end && edges_[e].a != edges_[e].b) {
            renumbered[e] = static_cast<std::uint32_t>(result.edges.size());
            result.edges.push_back({edges_[e].a, edges_[e].b});
        }
    }
    std::vector<std::uint32_t> open; // half-edges still to be followed, the next one last
    result.starts.push_back(0);
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        result.first.push_back(leader_[ends_[2 * i]]);
        if (lineEdge_[i] != kNoIndex) {
            open.push_back(lineEdge_[i]);
        }
        while (!open.empty()) {
            const std::uint32_t half = open.back(), back = half % 2;
            const Edge &e = edges_[half / 2];
            open.pop_back();
            if (e.child == e.end) {
                result.ways.push_back(2 * renumbered[half / 2] + back);
            } else if (back == 0) {
                open.insert(open.end(), std::reverse_iterator(children_.begin() + e.end),
                            std::reverse_iterator(children_.begin() + e.child));
            } else {
                for (std::uint32_t k = e.child; k < e.end; ++k) {
                    open.push_back(children_[k] ^ 1U);
                }
            }
        }
        result.starts.push_back(static_cast<std::uint32_t>(result.ways.size()));
    }
    return result;
}

} // namespace forefront
