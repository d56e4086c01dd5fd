#pragma once

#include "core/domain/domain.hpp"
#include "core/io/source/domain_origin.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace forefront {

/// Builds a domain from loops and chains given by coordinates, as drawings hold them. Equal coordinates are one node,
/// repeated consecutive ones are skipped, and a segment that an even number of loops share becomes an interface
/// (role Constraint), because crossing it does not leave the domain.
class DomainBuilder {
  public:
    /// `origin`: where to record the places of the parts; null: nowhere.
    explicit DomainBuilder(DomainOrigin *origin) : origin_(origin) {}

    /// Sets the offsets in the text of the nodes of what is added next; the last one serves for all that follow.
    void from(std::vector<std::size_t> offsets) { offsets_ = std::move(offsets); }
    /// Adds a closed loop, its first node not repeated.
    void addLoop(std::span<const Vec2> nodes, std::int32_t tag, SegmentRole role);
    /// Adds an open chain; where it lies on a segment of a loop, that segment takes the tag of the chain.
    void addChain(std::span<const Vec2> nodes, std::int32_t tag);
    void addPoint(Vec2 place, std::int32_t tag);
    void addRegion(Vec2 at, std::int32_t tag);

    Domain finish();

  private:
    struct Use {
        std::uint32_t loops = 0; ///< loops of role Boundary that run along it
        bool tagged = false;     ///< by a chain
    };

    /// `k`: number of the node in its loop or chain.
    std::uint32_t node(Vec2 place, std::size_t k);
    /// `k`: number of the node that it begins at.
    std::pair<DomainSegment &, Use &> segment(std::uint32_t a, std::uint32_t b, std::int32_t tag, std::size_t k);
    void note(DomainPartKind kind, std::size_t k);

    DomainOrigin *origin_;
    std::vector<std::size_t> offsets_;
    Domain domain_;
    std::vector<Use> uses_;                                     ///< per segment
    std::unordered_map<std::uint64_t, std::uint32_t> segments_; ///< by the pair of nodes; only looked up
    struct PlaceHash {
        std::size_t operator()(Vec2 p) const;
    };
    std::unordered_map<Vec2, std::uint32_t, PlaceHash> nodes_; ///< only looked up
};

/// Assigns tags to names: equal names share a tag; tags that are given as numbers are kept free.
class TagAllocator {
  public:
    void reserve(std::int32_t tag) { taken_.insert(tag); }
    /// Returns the tag of a name. The empty name has a tag too, without an entry in names().
    std::int32_t of(const std::string &name);
    const std::map<std::int32_t, std::string> &names() const { return names_; }
    void name(std::int32_t tag, const std::string &name) { names_.emplace(tag, name); }

  private:
    std::set<std::int32_t> taken_;
    std::map<std::string, std::int32_t> tags_;
    std::map<std::int32_t, std::string> names_;
};

/// Returns a point well inside the face that rings bound by the even-odd rule; nothing when they bound none.
std::optional<Vec2> pointInside(std::span<const std::vector<Vec2>> rings);

} // namespace forefront
