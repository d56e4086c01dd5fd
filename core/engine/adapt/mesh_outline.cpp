#include "core/engine/adapt/mesh_outline.hpp"

#include "core/engine/base/ids.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace forefront {

namespace {

constexpr double kStraight = 1e-9; ///< maximum sine of the angle at a dropped node

class StraightRuns {
  public:
    explicit StraightRuns(const Domain &domain)
        : domain_(domain), segmentsAt_(domain.nodes.size(), {kNoIndex, kNoIndex}), degree_(domain.nodes.size(), 0),
          numbers_(domain.nodes.size(), kNoIndex) {}

    Domain run() {
        for (std::uint32_t s = 0; s < domain_.segments.size(); ++s) {
            for (const std::uint32_t node : {domain_.segments[s].a, domain_.segments[s].b}) {
                if (degree_[node] < 2) {
                    segmentsAt_[node][degree_[node]] = s;
                }
                ++degree_[node];
            }
        }
        for (const ConstraintPoint &point : domain_.points) {
            degree_[point.node] = 0; // stays
        }
        result_ = domain_;
        result_.nodes.clear();
        result_.segments.clear();
        result_.points.clear();
        for (const ConstraintPoint &point : domain_.points) {
            result_.points.push_back({number(point.node), point.tag});
        }
        std::vector<bool> done(domain_.segments.size(), false);
        for (std::uint32_t s = 0; s < done.size(); ++s) {
            if (!done[s]) {
                addRun(s, done);
            }
        }
        return std::move(result_);
    }

  private:
    std::uint32_t number(std::uint32_t node) {
        if (numbers_[node] == kNoIndex) {
            numbers_[node] = static_cast<std::uint32_t>(result_.nodes.size());
            result_.nodes.push_back(domain_.nodes[node]);
        }
        return numbers_[node];
    }

    std::uint32_t other(std::uint32_t segment, std::uint32_t node) const {
        const DomainSegment &s = domain_.segments[segment];
        return s.a == node ? s.b : s.a;
    }

    bool isStraight(std::uint32_t node) const {
        if (degree_[node] != 2) {
            return false;
        }
        const auto [first, second] = segmentsAt_[node];
        const DomainSegment &a = domain_.segments[first], &b = domain_.segments[second];
        if (a.tag != b.tag || a.role != b.role || a.stretch.follows() || b.stretch.follows()) {
            return false;
        }
        const Vec2 in = domain_.nodes[node] - domain_.nodes[other(first, node)];
        const Vec2 out = domain_.nodes[other(second, node)] - domain_.nodes[node];
        return dot(in, out) > 0.0 && std::abs(cross(in, out)) <= kStraight * length(in) * length(out);
    }

    /// Returns the end of the straight run that continues a segment beyond one of its ends.
    std::uint32_t follow(std::uint32_t segment, std::uint32_t node, std::vector<bool> &done) const {
        const std::uint32_t first = segment;
        while (isStraight(node)) {
            segment = segmentsAt_[node][0] == segment ? segmentsAt_[node][1] : segmentsAt_[node][0];
            if (segment == first) {
                break;
            }
            done[segment] = true;
            node = other(segment, node);
        }
        return node;
    }

    void addRun(std::uint32_t segment, std::vector<bool> &done) {
        done[segment] = true;
        DomainSegment merged = domain_.segments[segment];
        const std::uint32_t a = follow(segment, merged.a, done);
        const std::uint32_t b = follow(segment, merged.b, done);
        merged.a = number(a);
        merged.b = number(b);
        result_.segments.push_back(merged);
    }

    const Domain &domain_;
    std::vector<std::array<std::uint32_t, 2>> segmentsAt_; ///< the first two at each node
    std::vector<std::uint32_t> degree_;
    std::vector<std::uint32_t> numbers_; ///< in the result
    Domain result_;
};

} // namespace

Domain withoutStraightNodes(const Domain &domain) {
    return StraightRuns(domain).run();
}

Result<MeshDomain> outlineOf(const MeshView &mesh, const Progress &progress) {
    Result<MeshDomain> made = domainOfMesh(mesh, progress);
    if (made) {
        made->domain = withoutStraightNodes(made->domain);
    }
    return made;
}

} // namespace forefront
