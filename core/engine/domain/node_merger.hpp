#pragma once

#include "core/engine/base/vec2.hpp"

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace forefront {

/// Gives coinciding nodes the same index. Coordinates that are not finite never coincide; validation reports each.
class NodeMerger {
  public:
    /// Keeps a reference to the list that it appends nodes to.
    explicit NodeMerger(std::vector<Vec2> &nodes) : nodes_(nodes) {}

    void reserve(std::size_t count) { places_.reserve(count); }

    /// Returns the index of the node at a place; appends one if there is none.
    std::uint32_t add(Vec2 p) {
        const auto next = static_cast<std::uint32_t>(nodes_.size());
        if (isFinite(p)) {
            const auto [place, fresh] = places_.emplace(p, next);
            if (!fresh) {
                return place->second;
            }
        }
        nodes_.push_back(p);
        return next;
    }

  private:
    /// Exact coordinates as a key; 0.0 and -0.0 are equal.
    struct Hash {
        std::size_t operator()(Vec2 p) const {
            const auto x = std::bit_cast<std::uint64_t>(p.x + 0.0), y = std::bit_cast<std::uint64_t>(p.y + 0.0);
            std::uint64_t h = x * 0x9e3779b97f4a7c15ULL ^ std::rotl(y * 0xc2b2ae3d27d4eb4fULL, 31);
            h ^= h >> 29;
            return static_cast<std::size_t>(h * 0x165667b19e3779f9ULL);
        }
    };

    std::vector<Vec2> &nodes_;
    std::unordered_map<Vec2, std::uint32_t, Hash> places_;
};

} // namespace forefront
