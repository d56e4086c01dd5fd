#include "core/io/common/domain_builder.hpp"

#include "core/base/hash.hpp"

#include <algorithm>

namespace forefront {

std::size_t DomainBuilder::PlaceHash::operator()(Vec2 p) const {
    Hash64 hash;
    hash.add(p.x);
    hash.add(p.y);
    return hash.value();
}

void DomainBuilder::note(DomainPartKind kind, std::size_t k) {
    if (origin_ != nullptr) {
        origin_->of(kind).push_back(
            {offsets_.empty() ? PartOrigin::kNowhere : offsets_[std::min(k, offsets_.size() - 1)], {}});
    }
}

std::uint32_t DomainBuilder::node(Vec2 place, std::size_t k) {
    const auto [entry, added] = nodes_.emplace(place, static_cast<std::uint32_t>(domain_.nodes.size()));
    if (added) {
        domain_.nodes.push_back(place);
        note(DomainPartKind::Node, k);
    }
    return entry->second;
}

std::pair<DomainSegment &, DomainBuilder::Use &> DomainBuilder::segment(std::uint32_t a, std::uint32_t b,
                                                                        std::int32_t tag, std::size_t k) {
    const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
    const auto [entry, added] = segments_.emplace(key, static_cast<std::uint32_t>(domain_.segments.size()));
    if (added) {
        domain_.segments.push_back({a, b, tag, SegmentRole::Constraint});
        uses_.emplace_back();
        note(DomainPartKind::Segment, k);
    }
    return {domain_.segments[entry->second], uses_[entry->second]};
}

void DomainBuilder::addLoop(std::span<const Vec2> nodes, std::int32_t tag, SegmentRole role) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t next = (k + 1) % nodes.size();
        const std::uint32_t a = node(nodes[k], k);
        const std::uint32_t b = node(nodes[next], next);
        if (a != b) {
            segment(a, b, tag, k).second.loops += role == SegmentRole::Boundary ? 1U : 0U;
        }
    }
}

void DomainBuilder::addChain(std::span<const Vec2> nodes, std::int32_t tag) {
    for (std::size_t k = 1; k < nodes.size(); ++k) {
        const std::uint32_t a = node(nodes[k - 1], k - 1);
        const std::uint32_t b = node(nodes[k], k);
        if (a != b) {
            auto [given, use] = segment(a, b, tag, k - 1);
            given.tag = tag;
            use.tagged = true;
        }
    }
}

void DomainBuilder::addPoint(Vec2 place, std::int32_t tag) {
    const std::uint32_t at = node(place, 0);
    domain_.points.push_back({at, tag});
    note(DomainPartKind::ConstraintPoint, 0);
}

void DomainBuilder::addRegion(Vec2 at, std::int32_t tag) {
    domain_.regionMarkers.push_back({at, tag});
    note(DomainPartKind::RegionMarker, 0);
}

Domain DomainBuilder::finish() {
    for (std::size_t s = 0; s < uses_.size(); ++s) {
        if (uses_[s].loops % 2 == 1) {
            domain_.segments[s].role = SegmentRole::Boundary;
        }
    }
    return std::move(domain_);
}

std::int32_t TagAllocator::of(const std::string &name) {
    const auto known = tags_.find(name);
    if (known != tags_.end()) {
        return known->second;
    }
    std::int32_t tag = static_cast<std::int32_t>(tags_.size()) + 1;
    while (!taken_.insert(tag).second) {
        ++tag;
    }
    tags_.emplace(name, tag);
    if (!name.empty()) {
        names_.emplace(tag, name);
    }
    return tag;
}

namespace {

/// The middle of the widest stretch inside along the horizontal line at y, with its width; y is no node's.
std::pair<double, Vec2> widestStretch(std::span<const std::vector<Vec2>> rings, double y) {
    std::vector<double> crossings;
    for (const std::vector<Vec2> &ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2 a = ring[k];
            const Vec2 b = ring[(k + 1) % ring.size()];
            if ((a.y < y) != (b.y < y)) {
                crossings.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }
        }
    }
    std::sort(crossings.begin(), crossings.end());
    std::pair<double, Vec2> best{0.0, {}};
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const double width = crossings[k + 1] - crossings[k];
        if (width > best.first) {
            best = {width, {crossings[k] + 0.5 * width, y}};
        }
    }
    return best;
}

} // namespace

std::optional<Vec2> pointInside(std::span<const std::vector<Vec2>> rings) {
    std::vector<double> heights;
    for (const std::vector<Vec2> &ring : rings) {
        for (const Vec2 p : ring) {
            heights.push_back(p.y);
        }
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    if (heights.size() < 2) {
        return std::nullopt;
    }
    // The tallest gaps between nodes give the roomiest lines; a few of them are enough.
    constexpr std::size_t kTried = 8;
    std::vector<std::size_t> gaps(heights.size() - 1);
    for (std::size_t k = 0; k < gaps.size(); ++k) {
        gaps[k] = k;
    }
    const std::size_t tried = std::min(kTried, gaps.size());
    std::partial_sort(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(tried), gaps.end(),
                      [&](std::size_t a, std::size_t b) {
                          const double heightA = heights[a + 1] - heights[a];
                          const double heightB = heights[b + 1] - heights[b];
                          return heightA != heightB ? heightA > heightB : a < b;
                      });
    std::pair<double, Vec2> best{0.0, {}};
    for (std::size_t k = 0; k < tried; ++k) {
        const double low = heights[gaps[k]];
        const double gap = heights[gaps[k] + 1] - low;
        const auto [width, middle] = widestStretch(rings, low + 0.5 * gap);
        const double room = std::min(width, gap);
        if (room > best.first) {
            best = {room, middle};
        }
    }
    return best.first > 0.0 ? std::optional(best.second) : std::nullopt;
}

} // namespace forefront
