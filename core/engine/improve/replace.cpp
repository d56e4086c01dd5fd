#include "core/engine/improve/replace.hpp"

#include "core/engine/base/assert.hpp"
#include "core/engine/mesh/quality.hpp"

#include <algorithm>
#include <iterator>

namespace forefront {

namespace {

std::size_t corner(std::uint32_t triple, unsigned k) {
    return triple >> (16U - 8U * k) & 0xffU;
}

/// Appends to a large array without doubling its memory.
template <class List, class Value>
void append(List &list, const Value &value) {
    constexpr std::size_t kShare = 32;
    if (list.size() == list.capacity()) {
        list.reserve(list.size() + list.size() / kShare + 1024);
    }
    list.push_back(value);
}

} // namespace

bool Replacer::isValid(const Cutout &after, double floor) const {
    std::array<Vec2, Cutout::kNodes> places;
    for (unsigned i = 0; i < after.count(); ++i) {
        const auto local = static_cast<Cutout::Local>(i);
        places[i] = after.inner(local) || after[i].id == kNoNode ? after.place(local) : work_.at(after[i].id);
    }
    bool good = true;
    after.forEachElement([&](Cutout::Local a, Cutout::Local b, Cutout::Local c) {
        const double alpha = shapeFactor(places[a], places[b], places[c]);
        good = good && alpha >= floor && surelyPositive(alpha, places[a], places[b], places[c]);
    });
    return good;
}

/// Finds the elements that only one of the cutouts has.
void Replacer::compare(const Cutout &before, const Cutout &after) {
    const auto list = [](const Cutout &cutout) {
        std::vector<Triple> all;
        all.reserve(2 * Cutout::kNodes);
        cutout.forEachElement([&all](Cutout::Local a, Cutout::Local b, Cutout::Local c) {
            all.push_back(static_cast<Triple>(a << 16U | b << 8U | c));
        });
        std::sort(all.begin(), all.end());
        return all;
    };
    const std::vector<Triple> given = list(before), changed = list(after);
    before_.clear();
    after_.clear();
    std::set_difference(given.begin(), given.end(), changed.begin(), changed.end(), std::back_inserter(before_));
    std::set_difference(changed.begin(), changed.end(), given.begin(), given.end(), std::back_inserter(after_));
}

/// Finds the old elements in the mesh and their neighbours across outer sides.
void Replacer::removeOld(const Cutout &before) {
    old_.clear();
    rim_.clear();
    for (const Triple triple : before_) {
        const NodeId b = before[corner(triple, 1)].id;
        work_.aroundFree(before[corner(triple, 0)].id, [&](HalfEdge h) {
            if (work_.to(h) == b) {
                old_.push_back(static_cast<std::uint32_t>(elementOf(h)));
            }
        });
    }
    for (const std::uint32_t e : old_) {
        for (unsigned k = 0; k < 3; ++k) {
            const HalfEdge h = 3 * e + k, g = work_.twin[h];
            if (g == kNoHalfEdge || std::find(old_.begin(), old_.end(), elementOf(g)) == old_.end()) {
                rim_.push_back({work_.from(h), work_.to(h), g});
            }
        }
    }
    region_ = old_.empty() ? 1 : work_.mesh.region(old_.front());
}

NodeId Replacer::newNode() {
    if (!freeNodes_.empty()) {
        const NodeId id = freeNodes_.back();
        freeNodes_.pop_back();
        work_.fixed[index(id)] = 0;
        return id;
    }
    const NodeId id{static_cast<std::uint32_t>(work_.mesh.nodes.size())};
    append(work_.mesh.nodes, Vec2{});
    append(work_.start, kNoHalfEdge);
    append(work_.fixed, std::uint8_t{0});
    append(work_.valence, std::uint8_t{0});
    append(work_.rings, ImproveWorkspace::Ring{});
    append(rho_, 0.0F);
    return id;
}

void Replacer::writeNodes(const Cutout &before, const Cutout &after) {
    ids_.assign(after.count(), kNoNode);
    changedNodes_.clear();
    for (unsigned i = 0; i < after.count(); ++i) {
        const auto local = static_cast<Cutout::Local>(i);
        NodeId &id = ids_[i] = after[i].id;
        if (after.inner(local)) {
            if (id == kNoNode) {
                id = newNode();
                rho_[index(id)] = after.rho(local);
            }
            work_.mesh.nodes[index(id)] = after.place(local);
            changedNodes_.push_back(id);
        } else if (i < before.count() && before.inner(local)) {
            freeNodes_.push_back(id);
            work_.fixed[index(id)] = 1;
            work_.valence[index(id)] = 0;
            work_.start[index(id)] = kNoHalfEdge;
        }
    }
}

/// Joins a side of a new element to its partner: across the rim, or of another new element.
void Replacer::joinSide(NodeId from, NodeId to, HalfEdge h) {
    const auto takeFrom = [&](std::vector<Side> &sides, NodeId a, NodeId b) {
        const auto found =
            std::find_if(sides.begin(), sides.end(), [&](const Side &s) { return s.from == a && s.to == b; });
        if (found == sides.end()) {
            return false;
        }
        work_.twin[h] = found->half;
        if (found->half != kNoHalfEdge) {
            work_.twin[found->half] = h;
        }
        *found = sides.back();
        sides.pop_back();
        return true;
    };
    if (!takeFrom(rim_, from, to) && !takeFrom(open_, to, from)) {
        open_.push_back({from, to, h});
    }
}

std::uint32_t Replacer::slotFor(std::size_t added) {
    if (added < old_.size()) {
        return old_[added];
    }
    if (!freeElements_.empty()) {
        const std::uint32_t e = freeElements_.back();
        freeElements_.pop_back();
        return e;
    }
    const auto e = static_cast<std::uint32_t>(work_.mesh.elements.size());
    append(work_.mesh.elements, Element{kNoNode, kNoNode, kNoNode});
    append(work_.alpha, 1.0F);
    for (unsigned k = 0; k < 3; ++k) {
        append(work_.twin, kNoHalfEdge);
    }
    if (!work_.mesh.regions.empty()) {
        append(work_.mesh.regions, region_);
    }
    return e;
}

void Replacer::insertNew() {
    open_.clear();
    changedElements_ = old_;
    for (std::size_t n = 0; n < after_.size(); ++n) {
        const std::uint32_t e = slotFor(n);
        changedElements_.push_back(e);
        if (!work_.mesh.regions.empty()) {
            work_.mesh.regions[e] = region_;
        }
        Element &element = work_.mesh.elements[e];
        for (unsigned k = 0; k < 3; ++k) {
            element[k] = ids_[corner(after_[n], k)];
            work_.start[index(element[k])] = 3 * e + k;
        }
        for (unsigned k = 0; k < 3; ++k) {
            joinSide(element[k], element[(k + 1) % 3], 3 * e + k);
        }
    }
    for (std::size_t n = after_.size(); n < old_.size(); ++n) {
        work_.mesh.elements[old_[n]] = {kNoNode, kNoNode, kNoNode};
        std::fill_n(work_.twin.begin() + 3 * static_cast<std::ptrdiff_t>(old_[n]), 3, kNoHalfEdge);
        freeElements_.push_back(old_[n]);
    }
    FOREFRONT_ASSERT(rim_.empty() && open_.empty());
    for (const Triple triple : after_) {
        for (unsigned k = 0; k < 3; ++k) {
            if (const NodeId n = ids_[corner(triple, k)]; work_.isFree(n)) {
                work_.renewRing(n);
            }
        }
    }
}

/// Checks the numbers of elements by Euler's formula, which a change that leaves a gap or an overlap violates.
bool Replacer::countsFit(const Cutout &before, const Cutout &after) const {
    const auto innerOf = [](const Cutout &cutout) {
        std::ptrdiff_t sum = 0;
        for (unsigned n = 0; n < cutout.count(); ++n) {
            sum += cutout.inner(static_cast<Cutout::Local>(n)) ? 1 : 0;
        }
        return sum;
    };
    return static_cast<std::ptrdiff_t>(after_.size()) - static_cast<std::ptrdiff_t>(before_.size()) ==
           2 * (innerOf(after) - innerOf(before));
}

bool Replacer::replace(const Cutout &before, const Cutout &after, double floor) {
    if (work_.mesh.elements.size() + 2 > ImproveWorkspace::kMaxElements || !isValid(after, floor)) {
        return false;
    }
    compare(before, after);
    if (!countsFit(before, after)) {
        return false;
    }
    removeOld(before);
    writeNodes(before, after);
    insertNew();
    return true;
}

void Replacer::moveElement(std::uint32_t from, std::uint32_t to) {
    work_.mesh.elements[to] = work_.mesh.elements[from];
    if (!work_.mesh.regions.empty()) {
        work_.mesh.regions[to] = work_.mesh.regions[from];
    }
    for (unsigned k = 0; k < 3; ++k) {
        const HalfEdge oldHalf = 3 * from + k, newHalf = 3 * to + k, across = work_.twin[oldHalf];
        work_.twin[newHalf] = across;
        if (across != kNoHalfEdge) {
            work_.twin[across] = newHalf;
        }
        HalfEdge &start = work_.start[index(work_.from(newHalf))];
        start = start == oldHalf ? newHalf : start;
    }
}

void Replacer::compactElements() {
    TriMesh &mesh = work_.mesh;
    const std::size_t kept = mesh.elements.size() - freeElements_.size();
    std::sort(freeElements_.begin(), freeElements_.end());
    auto last = static_cast<std::uint32_t>(mesh.elements.size());
    for (const std::uint32_t gap : freeElements_) {
        if (gap >= kept) {
            break;
        }
        do {
            --last;
        } while (mesh.elements[last][0] == kNoNode);
        moveElement(last, gap);
    }
    freeElements_.clear();
    mesh.elements.resize(kept);
    mesh.regions.resize(mesh.regions.empty() ? 0 : kept);
    work_.twin.resize(3 * kept);
    work_.alpha.resize(kept);
}

void Replacer::compactNodes() {
    TriMesh &mesh = work_.mesh;
    const std::size_t kept = mesh.nodes.size() - freeNodes_.size();
    std::vector<NodeId> places(freeNodes_.size(), kNoNode); // new ids of the last nodes; kNoNode for removed ones
    std::sort(freeNodes_.begin(), freeNodes_.end());
    auto gap = freeNodes_.begin();
    for (std::size_t n = kept; n < mesh.nodes.size(); ++n) {
        if (std::binary_search(gap, freeNodes_.end(), NodeId{static_cast<std::uint32_t>(n)})) {
            continue;
        }
        const std::size_t to = index(*gap++);
        places[n - kept] = NodeId{static_cast<std::uint32_t>(to)};
        mesh.nodes[to] = mesh.nodes[n];
        work_.start[to] = work_.start[n];
        work_.fixed[to] = work_.fixed[n];
        work_.valence[to] = work_.valence[n];
        rho_[to] = rho_[n];
    }
    freeNodes_.clear();
    renumber(kept, places);
    mesh.nodes.resize(kept);
    work_.start.resize(kept);
    work_.fixed.resize(kept);
    work_.valence.resize(kept);
    work_.rings.resize(kept);
    rho_.resize(kept);
}

void Replacer::renumber(std::size_t kept, const std::vector<NodeId> &places) {
    TriMesh &mesh = work_.mesh;
    const auto move = [&](NodeId &n) {
        const bool moved = index(n) >= kept;
        n = moved ? places[index(n) - kept] : n;
        return moved;
    };
    std::vector<std::vector<std::uint32_t>> changed((mesh.elements.size() + ImproveWorkspace::kChunk - 1) /
                                                    ImproveWorkspace::kChunk);
    work_.pool.forChunks(mesh.elements.size(), ImproveWorkspace::kChunk,
                         [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                             for (std::size_t e = begin; e < end; ++e) {
                                 Element &n = mesh.elements[e];
                                 const bool first = move(n[0]), second = move(n[1]), third = move(n[2]);
                                 if (first || second || third) {
                                     changed[chunk].push_back(static_cast<std::uint32_t>(e));
                                 }
                             }
                         });
    for (TaggedEdge &edge : mesh.edges) {
        move(edge.a);
        move(edge.b);
    }
    for (TaggedNode &point : mesh.points) {
        move(point.node);
    }
    for (const auto &some : changed) {
        for (const std::uint32_t e : some) {
            for (const NodeId n : mesh.elements[e]) {
                if (work_.isFree(n)) {
                    work_.renewRing(n);
                }
            }
        }
    }
}

void Replacer::compact() {
    if (!freeElements_.empty()) {
        compactElements();
    }
    if (!freeNodes_.empty()) {
        compactNodes();
    }
}

} // namespace forefront
