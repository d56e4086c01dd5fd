#pragma once

#include "core/engine/domain/domain.hpp"

#include <cstdint>
#include <random>

namespace forefront::testing {

/// Families of valid domains, some ordinary and some hostile. All are even-odd, with 3 to a few hundred segments.
enum class DomainFamily : std::uint8_t {
    StarWithHoles,   ///< a star-shaped outline and holes of any size
    NestedIslands,   ///< holes in islands in holes
    Comb,            ///< narrow teeth and gaps
    Spiral,          ///< a band wound up
    Spikes,          ///< needles outwards and inwards
    SizeRatio,       ///< features 10⁴ times smaller than the domain
    FarAway,         ///< one of those above, 10⁵ and more away from the origin
    Constraints,     ///< polylines (free, branched, from boundary nodes, closed) and points inside; region markers
    SeveralOutlines, ///< parts apart from each other and parts that touch at a node
    Lattice          ///< unions of lattice cells: collinear nodes, pinches, holes, all exactly axis-parallel
};
inline constexpr int kDomainFamilies = 10;
const char *nameOf(DomainFamily family);

/// Returns a valid domain, always the same for the same family and seed. Order and direction of its segments are
/// shuffled.
Domain randomDomain(DomainFamily family, std::uint64_t seed);
/// Returns a domain of the family seed modulo kDomainFamilies.
Domain randomDomain(std::uint64_t seed);

/// Random numbers that do not depend on the standard library's distributions.
class RandomSource {
  public:
    explicit RandomSource(std::uint64_t seed) : random_(seed * 0x9e3779b97f4a7c15ULL + 1U) {}

    double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; } ///< in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    int integer(int low, int high) { ///< in [low, high]
        return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double probability) { return unit() < probability; }

  private:
    std::mt19937_64 random_;
};

} // namespace forefront::testing
