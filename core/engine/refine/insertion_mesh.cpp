#include "core/engine/refine/insertion_mesh.hpp"

#include "core/engine/geometry/predicates.hpp"
#include "core/engine/mesh/topology.hpp"

#include <algorithm>

namespace forefront {

InsertionMesh::InsertionMesh(TriMesh &mesh) : mesh_(mesh) {
    const EdgeTable table(mesh);
    across_ = oppositeHalfEdges(table);
    tagged_.assign(across_.size(), kNoIndex);
    sideOfTagged_.assign(mesh.edges.size(), kNoHalfEdge);
    for (std::uint32_t i = 0; i < mesh.edges.size(); ++i) {
        for (const HalfEdge h : table.find(mesh.edges[i].a, mesh.edges[i].b)) {
            tagged_[h] = i;
            sideOfTagged_[i] = h;
        }
    }
    mark_.assign(mesh.elements.size(), 0);
}

InsertionMesh::Walk InsertionMesh::walk(std::size_t element, Vec2 to) const {
    const Element &e = mesh_.elements[element];
    const Vec2 from = (1.0 / 3.0) * (place(e[0]) + place(e[1]) + place(e[2]));
    HalfEdge entry = kNoHalfEdge;
    for (std::size_t steps = 0; steps <= mesh_.elements.size(); ++steps) {
        // Leaves through the side that the point lies beyond and that the line towards it crosses.
        HalfEdge exit = kNoHalfEdge, on = kNoHalfEdge;
        for (unsigned k = 0; k < 3; ++k) {
            const auto h = static_cast<HalfEdge>(3 * element + k);
            if (h == entry) {
                continue;
            }
            const Vec2 a = place(startOf(h)), b = place(endOf(h));
            const int side = orientation(a, b, to);
            if (side < 0 && orientation(from, to, a) <= 0 && orientation(from, to, b) >= 0) {
                exit = h;
            } else if (side == 0 && onSegment(a, b, to)) {
                on = h;
            }
        }
        if (exit == kNoHalfEdge) {
            const Element &n = mesh_.elements[element];
            if (std::any_of(n.begin(), n.end(), [&](NodeId node) { return place(node) == to; })) {
                return {};
            }
            if (on != kNoHalfEdge) {
                return {tagged_[on] == kNoIndex ? Walk::End::Inside : Walk::End::Blocked, on};
            }
            const bool inside = orientation(place(n[0]), place(n[1]), to) > 0 &&
                                orientation(place(n[1]), place(n[2]), to) > 0 &&
                                orientation(place(n[2]), place(n[0]), to) > 0;
            return inside ? Walk{Walk::End::Inside, static_cast<HalfEdge>(3 * element)} : Walk{};
        }
        if (tagged_[exit] != kNoIndex || across_[exit] == kNoHalfEdge) {
            return {Walk::End::Blocked, exit};
        }
        entry = across_[exit];
        element = elementOf(entry);
    }
    return {};
}

void InsertionMesh::tagsAround(std::size_t element, Vec2 point, std::vector<std::uint32_t> &found) {
    ++round_;
    cavity_.assign(1, static_cast<std::uint32_t>(element));
    mark_[element] = round_;
    for (std::size_t i = 0; i < cavity_.size(); ++i) {
        for (unsigned k = 0; k < 3; ++k) {
            const HalfEdge h = 3 * cavity_[i] + k;
            if (tagged_[h] != kNoIndex) {
                found.push_back(tagged_[h]);
                continue;
            }
            const HalfEdge g = across_[h];
            if (g == kNoHalfEdge || mark_[elementOf(g)] == round_) {
                continue;
            }
            const Element &e = mesh_.elements[elementOf(g)];
            if (inCircle(place(e[0]), place(e[1]), place(e[2]), point) > 0) {
                mark_[elementOf(g)] = round_;
                cavity_.push_back(static_cast<std::uint32_t>(elementOf(g)));
            }
        }
    }
}

bool InsertionMesh::failsCircleTest(HalfEdge h) const {
    const HalfEdge g = across_[h];
    return tagged_[h] == kNoIndex && g != kNoHalfEdge &&
           inCircle(place(startOf(h)), place(endOf(h)), place(apexOf(h)), place(apexOf(g))) > 0;
}

void InsertionMesh::swapAround(std::size_t element) {
    changed_.clear();
    for (unsigned k = 0; k < 3; ++k) {
        open_.push_back(static_cast<HalfEdge>(3 * element + k));
    }
    while (!open_.empty()) {
        const HalfEdge h = open_.back();
        open_.pop_back();
        if (!failsCircleTest(h)) {
            continue;
        }
        const auto e = static_cast<HalfEdge>(3 * elementOf(h)), f = static_cast<HalfEdge>(3 * elementOf(across_[h]));
        swap(h);
        for (const HalfEdge side : {e, e + 2, f, f + 1}) { // the rim of both; see swap()
            open_.push_back(side);
        }
    }
}

bool InsertionMesh::positive(NodeId a, NodeId b, Vec2 point) const {
    return orientation(place(a), place(b), point) > 0;
}

std::uint32_t InsertionMesh::newElement(std::size_t like) {
    mesh_.elements.emplace_back();
    if (!mesh_.regions.empty()) {
        mesh_.regions.push_back(mesh_.regions[like]);
    }
    across_.insert(across_.end(), 3, kNoHalfEdge);
    tagged_.insert(tagged_.end(), 3, kNoIndex);
    mark_.push_back(0);
    return elementCount() - 1;
}

void InsertionMesh::beginTrial() {
    trial_.active = true;
    trial_.nodes = mesh_.nodes.size();
    trial_.elementCount = mesh_.elements.size();
    trial_.edgeCount = mesh_.edges.size();
    trial_.swaps = swaps_;
    trial_.elements.clear();
    trial_.sides.clear();
    trial_.sidesOfTagged.clear();
    trial_.edges.clear();
}

/// Records what set() is about to overwrite, if it was there when the trial began.
void InsertionMesh::record(std::size_t element, const std::array<Side, 3> &next) {
    const auto recordSide = [&](HalfEdge h) {
        if (elementOf(h) < trial_.elementCount) {
            trial_.sides.emplace_back(h, sideAt(h));
        }
    };
    const bool known = std::any_of(trial_.elements.begin(), trial_.elements.end(),
                                   [&](const auto &old) { return old.first == element; });
    if (element < trial_.elementCount && !known) {
        trial_.elements.emplace_back(static_cast<std::uint32_t>(element), mesh_.elements[element]);
    }
    for (unsigned k = 0; k < 3; ++k) {
        recordSide(static_cast<HalfEdge>(3 * element + k));
        if (next[k].across != kNoHalfEdge) {
            recordSide(next[k].across);
        }
        if (next[k].tagged < trial_.edgeCount) {
            trial_.sidesOfTagged.emplace_back(next[k].tagged, sideOfTagged_[next[k].tagged]);
        }
    }
}

void InsertionMesh::undoTrial() {
    std::for_each(trial_.elements.rbegin(), trial_.elements.rend(),
                  [&](const auto &old) { mesh_.elements[old.first] = old.second; });
    std::for_each(trial_.sides.rbegin(), trial_.sides.rend(), [&](const auto &old) {
        across_[old.first] = old.second.across;
        tagged_[old.first] = old.second.tagged;
    });
    std::for_each(trial_.sidesOfTagged.rbegin(), trial_.sidesOfTagged.rend(),
                  [&](const auto &old) { sideOfTagged_[old.first] = old.second; });
    std::for_each(trial_.edges.rbegin(), trial_.edges.rend(),
                  [&](const auto &old) { mesh_.edges[old.first] = old.second; });
    mesh_.nodes.resize(trial_.nodes);
    mesh_.elements.resize(trial_.elementCount);
    if (!mesh_.regions.empty()) {
        mesh_.regions.resize(trial_.elementCount);
    }
    mesh_.edges.resize(trial_.edgeCount);
    sideOfTagged_.resize(trial_.edgeCount);
    across_.resize(3 * trial_.elementCount);
    tagged_.resize(3 * trial_.elementCount);
    mark_.resize(trial_.elementCount);
    swaps_ = trial_.swaps;
    changed_.clear();
    trial_.active = false;
}

void InsertionMesh::set(std::size_t element, const Element &nodes, const std::array<Side, 3> &sides) {
    if (trial_.active) {
        record(element, sides);
    }
    mesh_.elements[element] = nodes;
    for (unsigned k = 0; k < 3; ++k) {
        const auto h = static_cast<HalfEdge>(3 * element + k);
        across_[h] = sides[k].across;
        tagged_[h] = sides[k].tagged;
        if (sides[k].across != kNoHalfEdge) {
            across_[sides[k].across] = h;
        }
        if (sides[k].tagged != kNoIndex) {
            sideOfTagged_[sides[k].tagged] = h;
        }
    }
    changed_.push_back(static_cast<std::uint32_t>(element));
}

void InsertionMesh::swap(HalfEdge h) {
    // The elements abc and bad become adc and dbc. Sides across the new edge have the numbers that they get.
    const HalfEdge g = across_[h];
    const std::size_t e = elementOf(h), f = elementOf(g);
    const auto next = [](HalfEdge s) { return s % 3 == 2 ? s - 2 : s + 1; };
    const NodeId a = startOf(h), b = endOf(h), c = apexOf(h), d = apexOf(g);
    const Side ad = sideAt(next(g)), ca = sideAt(next(next(h))), db = sideAt(next(next(g))), bc = sideAt(next(h));
    set(e, {a, d, c}, {ad, Side{static_cast<HalfEdge>(3 * f + 2), kNoIndex}, ca});
    set(f, {d, b, c}, {db, bc, Side{static_cast<HalfEdge>(3 * e + 1), kNoIndex}});
    ++swaps_;
}

/// Swaps the edges across from a new node, the last node of each of its elements, by the circle test.
void InsertionMesh::swapWhereNeeded() {
    while (!open_.empty()) {
        const HalfEdge h = open_.back(); // the new node is the apex
        open_.pop_back();
        if (!failsCircleTest(h)) {
            continue;
        }
        const auto e = static_cast<HalfEdge>(3 * elementOf(h)), f = static_cast<HalfEdge>(3 * elementOf(across_[h]));
        swap(h); // the new node is the last of both
        open_.push_back(e);
        open_.push_back(f);
    }
}

void InsertionMesh::splitElement(std::size_t element, NodeId node) {
    const auto [a, b, c] = mesh_.elements[element];
    const auto h = static_cast<HalfEdge>(3 * element);
    const Side ab = sideAt(h), bc = sideAt(h + 1), ca = sideAt(h + 2);
    const HalfEdge f = 3 * newElement(element), g = 3 * newElement(element);
    set(element, {a, b, node}, {ab, Side{f + 2, kNoIndex}, Side{g + 1, kNoIndex}});
    set(f / 3, {b, c, node}, {bc, Side{g + 2, kNoIndex}, Side{h + 1, kNoIndex}});
    set(g / 3, {c, a, node}, {ca, Side{h + 2, kNoIndex}, Side{f + 1, kNoIndex}});
    open_.assign({h, f, g});
}

/// Divides the edge of a half-edge h = ab by a node p. `first`, `second`: the tagged edges of ap and pb.
void InsertionMesh::splitEdge(HalfEdge h, NodeId node, std::uint32_t first, std::uint32_t second) {
    const auto next = [](HalfEdge s) { return s % 3 == 2 ? s - 2 : s + 1; };
    const HalfEdge g = across_[h];
    const NodeId a = startOf(h), b = endOf(h), c = apexOf(h);
    const Side bc = sideAt(next(h)), ca = sideAt(next(next(h)));
    const auto e = static_cast<HalfEdge>(3 * elementOf(h));
    const HalfEdge f = 3 * newElement(elementOf(h));
    open_.assign({e, f});
    // cap and bcp; the new node is the last of both.
    set(e / 3, {c, a, node}, {ca, Side{kNoHalfEdge, first}, Side{f + 1, kNoIndex}});
    set(f / 3, {b, c, node}, {bc, Side{e + 2, kNoIndex}, Side{kNoHalfEdge, second}});
    if (g != kNoHalfEdge) {
        const NodeId d = apexOf(g);
        const Side ad = sideAt(next(g)), db = sideAt(next(next(g)));
        const auto i = static_cast<HalfEdge>(3 * elementOf(g));
        const HalfEdge j = 3 * newElement(elementOf(g));
        set(i / 3, {d, b, node}, {db, Side{f + 2, second}, Side{j + 1, kNoIndex}});
        set(j / 3, {a, d, node}, {ad, Side{i + 2, kNoIndex}, Side{e + 1, first}});
        open_.insert(open_.end(), {i, j});
    }
}

bool InsertionMesh::insertOnEdge(HalfEdge h, Vec2 point) {
    const HalfEdge g = across_[h];
    const NodeId a = startOf(h), b = endOf(h), c = apexOf(h);
    if (!positive(c, a, point) || !positive(b, c, point) ||
        (g != kNoHalfEdge && (!positive(apexOf(g), b, point) || !positive(a, apexOf(g), point)))) {
        return false;
    }
    const NodeId node{static_cast<std::uint32_t>(mesh_.nodes.size())};
    mesh_.nodes.push_back(point);
    const std::uint32_t edge = tagged_[h];
    std::uint32_t first = kNoIndex, second = kNoIndex;
    if (edge != kNoIndex) {
        first = edge;
        second = static_cast<std::uint32_t>(mesh_.edges.size());
        TaggedEdge half = mesh_.edges[edge];
        if (trial_.active && edge < trial_.edgeCount) {
            trial_.edges.emplace_back(edge, half);
        }
        half.a = mesh_.edges[edge].b = node;
        mesh_.edges.push_back(half);
        sideOfTagged_.push_back(kNoHalfEdge);
        if (mesh_.edges[edge].a != a) { // the half-edge runs backwards
            std::swap(first, second);
        }
    }
    changed_.clear();
    splitEdge(h, node, first, second);
    swapWhereNeeded();
    return true;
}

bool InsertionMesh::insert(std::size_t element, Vec2 point) {
    const Element e = mesh_.elements[element];
    for (unsigned k = 0; k < 3; ++k) {
        if (orientation(place(e[k]), place(e[(k + 1) % 3]), point) == 0) {
            return insertOnEdge(static_cast<HalfEdge>(3 * element + k), point);
        }
    }
    if (!positive(e[0], e[1], point) || !positive(e[1], e[2], point) || !positive(e[2], e[0], point)) {
        return false;
    }
    const NodeId node{static_cast<std::uint32_t>(mesh_.nodes.size())};
    mesh_.nodes.push_back(point);
    changed_.clear();
    splitElement(element, node);
    swapWhereNeeded();
    return true;
}

bool InsertionMesh::divide(std::uint32_t edge, Vec2 point) {
    return insertOnEdge(sideOfTagged_[edge], point);
}

} // namespace forefront
