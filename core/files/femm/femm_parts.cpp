#include "core/files/femm/femm_parts.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/domain/lazy_faces.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

namespace {

class FemmSettler {
  public:
    FemmSettler(const SourceText &source, Domain &domain, DomainOrigin &origin, std::int32_t pointTag)
        : source_(source), domain_(domain), origin_(origin), pointTag_(pointTag) {}

    /// Returns true if segments were left out, which may have joined a hole with the outside.
    bool pass() {
        findLoneNodes();
        const LazyFaces lazy(domain_, {}, lonePlaces_);
        const DomainFaces *const found = lazy.get();
        if (found == nullptr || lazy.inside() == nullptr) {
            return false;
        }
        const std::vector<std::uint8_t> unusedSegments = outsideSegments(*found), unusedNodes = settleNodes(*found);
        const auto outside = [found](std::uint32_t point) {
            const std::uint32_t face = found->faces.ofPoint[point];
            return face != kNoIndex && found->labels.inside[face] == 0;
        };
        const auto unbounded = [found](std::uint32_t point) { return found->faces.ofPoint[point] == 0; };
        const std::vector<std::uint8_t> unusedLabels = flagged(found->graph.regionMarker, outside),
                                        unusedHoles = flagged(found->graph.holeMarker, unbounded);
        const bool opened = leaveOut(domain_.segments, unusedSegments, DomainPartKind::Segment, "segments");
        leaveOut(domain_.regionMarkers, unusedLabels, DomainPartKind::RegionMarker, "block labels");
        leaveOut(domain_.holeMarkers, unusedHoles, DomainPartKind::HoleMarker, "holes");
        renumber(unusedNodes);
        leaveOut(domain_.nodes, unusedNodes, DomainPartKind::Node, "nodes of no segment");
        return opened;
    }

  private:
    void findLoneNodes() {
        loneNodes_.clear();
        lonePlaces_.clear();
        std::vector<std::uint8_t> used(domain_.nodes.size(), 0);
        for (const DomainSegment &segment : domain_.segments) {
            used[segment.a] = used[segment.b] = 1;
        }
        for (std::uint32_t n = 0; n < used.size(); ++n) {
            if (used[n] == 0) {
                loneNodes_.push_back(n);
                lonePlaces_.push_back(domain_.nodes[n]);
            }
        }
    }

    std::vector<std::uint8_t> outsideSegments(const DomainFaces &found) const {
        std::vector<std::uint8_t> unused(domain_.segments.size(), 0);
        for (std::size_t e = 0; e < found.graph.edges.size(); ++e) {
            unused[found.graph.segment[e]] = static_cast<std::uint8_t>(found.labels.inside[found.faces.left[e]] == 0 &&
                                                                       found.labels.inside[found.faces.right[e]] == 0);
        }
        return unused;
    }

    /// Makes inner points of the lone nodes that are not outside, and returns flags of the others.
    std::vector<std::uint8_t> settleNodes(const DomainFaces &found) {
        std::vector<std::uint8_t> unused(domain_.nodes.size(), 0), named(domain_.nodes.size(), 0);
        for (const ConstraintPoint &point : domain_.points) {
            named[point.node] = 1;
        }
        for (std::size_t k = 0; k < loneNodes_.size(); ++k) {
            const std::uint32_t point = found.graph.place[k];
            const std::uint32_t face = point != kNoIndex ? found.faces.ofPoint[point] : kNoIndex;
            if (face != kNoIndex && found.labels.inside[face] == 0) {
                unused[loneNodes_[k]] = 1;
            } else if (named[loneNodes_[k]] == 0) {
                domain_.points.push_back({loneNodes_[k], pointTag_});
            }
        }
        std::erase_if(domain_.points, [&](const ConstraintPoint &point) { return unused[point.node] != 0; });
        return unused;
    }

    template <class Test>
    static std::vector<std::uint8_t> flagged(const std::vector<std::uint32_t> &points, Test test) {
        std::vector<std::uint8_t> flags;
        flags.reserve(points.size());
        for (const std::uint32_t point : points) {
            flags.push_back(static_cast<std::uint8_t>(point != kNoIndex && test(point)));
        }
        return flags;
    }

    void renumber(const std::vector<std::uint8_t> &unused) {
        std::vector<std::uint32_t> number(unused.size(), 0);
        std::uint32_t next = 0;
        for (std::size_t n = 0; n < unused.size(); ++n) {
            number[n] = next;
            next += unused[n] == 0 ? 1 : 0;
        }
        for (DomainSegment &segment : domain_.segments) {
            segment.a = number[segment.a];
            segment.b = number[segment.b];
        }
        for (ConstraintPoint &point : domain_.points) {
            point.node = number[point.node];
        }
    }

    /// Returns true if there were such parts.
    template <class Part>
    bool leaveOut(std::vector<Part> &parts, const std::vector<std::uint8_t> &unused, DomainPartKind kind,
                  const char *what) {
        std::vector<PartOrigin> &origins = origin_.of(kind);
        std::size_t kept = 0, offset = 0, count = 0;
        for (std::size_t k = 0; k < parts.size(); ++k) {
            if (unused[k] == 0) {
                parts[kept] = parts[k];
                origins[kept] = origins[k];
                ++kept;
            } else if (++count == 1) {
                offset = origins[k].offset;
            }
        }
        parts.resize(kept);
        origins.resize(kept);
        if (count > 0) {
            source_.note("femm-outside", std::string(what) + " outside the domain are left out", offset, count);
        }
        return count > 0;
    }

    const SourceText &source_;
    Domain &domain_;
    DomainOrigin &origin_;
    std::int32_t pointTag_;
    std::vector<std::uint32_t> loneNodes_;
    std::vector<Vec2> lonePlaces_;
};

} // namespace

void settleFemmParts(const SourceText &source, Domain &domain, DomainOrigin &origin, std::int32_t pointTag) {
    FemmSettler settler(source, domain, origin, pointTag);
    while (settler.pass()) {
    }
}

} // namespace forefront
