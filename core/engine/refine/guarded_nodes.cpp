#include "core/engine/refine/guarded_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace forefront {

double leastAngleCosine(const TriMesh &mesh, const Element &element) {
    double cosine = -1.0;
    for (unsigned k = 0; k < 3; ++k) {
        const Vec2 at = mesh.nodes[index(element[k])];
        const Vec2 u = mesh.nodes[index(element[(k + 1) % 3])] - at, v = mesh.nodes[index(element[(k + 2) % 3])] - at;
        cosine = std::max(cosine, dot(u, v) / std::sqrt(lengthSquared(u) * lengthSquared(v)));
    }
    return cosine;
}

GuardedNodes::GuardedNodes(const TriMesh &given, const std::function<bool(std::uint32_t edge)> &isKept) {
    for (std::uint32_t i = 0; i < given.edges.size(); ++i) {
        if (isKept(i)) {
            guarded_.resize(given.nodes.size());
            guarded_[index(given.edges[i].a)] = guarded_[index(given.edges[i].b)] = true;
            any_ = true;
        }
    }
    if (!any_) {
        return;
    }
    cosine_.assign(given.nodes.size(), -1.0);
    for (const Element &element : given.elements) {
        const double cosine = leastAngleCosine(given, element);
        for (const NodeId n : element) {
            cosine_[index(n)] = std::max(cosine_[index(n)], cosine);
        }
    }
    origin_.resize(given.nodes.size());
    std::iota(origin_.begin(), origin_.end(), 0U);
}

bool GuardedNodes::guards(const Element &element) const {
    return std::any_of(element.begin(), element.end(), [&](NodeId n) { return guarded_[index(n)]; });
}

void GuardedNodes::add(const Element &around, unsigned corners) {
    bool guarded = true;
    double cosine = -1.0;
    for (unsigned k = 0; k < corners; ++k) {
        guarded = guarded && guarded_[index(around[k])];
        cosine = std::max(cosine, cosine_[index(around[k])]);
    }
    guarded_.push_back(guarded);
    cosine_.push_back(cosine);
    origin_.push_back(origin_[index(around[0])]);
}

void GuardedNodes::removeLast() {
    guarded_.pop_back();
    cosine_.pop_back();
    origin_.pop_back();
}

double GuardedNodes::given(const Element &element) const {
    return std::max({cosine_[index(element[0])], cosine_[index(element[1])], cosine_[index(element[2])]});
}

void GuardedNodes::blame(const Element &element) {
    for (const NodeId n : element) {
        blamed_.push_back(origin_[index(n)]);
    }
}

void GuardedNodes::forgetNew(const TriMesh &given) {
    guarded_.resize(given.nodes.size());
    cosine_.resize(given.nodes.size());
    origin_.resize(given.nodes.size());
    blamed_.clear();
}

void GuardedNodes::extend(const TriMesh &given, unsigned rings) {
    std::vector<bool> reached(given.nodes.size(), false);
    for (const std::uint32_t n : blamed_) {
        reached[n] = true;
    }
    for (unsigned ring = 0; ring < rings; ++ring) {
        std::vector<bool> next = reached;
        for (const Element &element : given.elements) {
            if (std::any_of(element.begin(), element.end(), [&](NodeId n) { return reached[index(n)]; })) {
                for (const NodeId n : element) {
                    next[index(n)] = true;
                }
            }
        }
        reached.swap(next);
    }
    forgetNew(given);
    for (std::size_t n = 0; n < reached.size(); ++n) {
        guarded_[n] = guarded_[n] || reached[n];
    }
}

void GuardedNodes::guardAll(const TriMesh &given) {
    forgetNew(given);
    guarded_.assign(given.nodes.size(), true);
}

} // namespace forefront
