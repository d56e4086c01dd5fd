#include "core/drawing_files/common/open_outline.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/engine/base/rows.hpp"
#include "core/engine/geometry/box_tree.hpp"
#include "core/engine/geometry/predicates.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kGapSpare = 1.05; ///< by which an advised tolerance exceeds the gap

Box2 boxOfNodes(const std::vector<Vec2> &nodes) {
    Box2 box;
    for (const Vec2 node : nodes) {
        box.add(node);
    }
    return box;
}

double boxArea(const Box2 &box) {
    return box.empty() ? 0.0 : box.size().x * box.size().y;
}

/// Returns true if a box reaches beyond another.
bool reachesBeyond(Box2 box, const Box2 &other) {
    box.add(other);
    return boxArea(box) > 1.001 * boxArea(other); // curves are divided elsewhere once lines are joined
}

/// The nodes on the boundary of a domain.
class BoundaryNodes {
  public:
    explicit BoundaryNodes(const Domain &domain) {
        std::vector<Box2> boxes;
        for (const DomainSegment &segment : domain.segments) {
            if (segment.role == SegmentRole::Boundary) {
                for (const std::uint32_t node : {segment.a, segment.b}) {
                    nodes_.push_back(domain.nodes[node]);
                    boxes.push_back(boxOf(nodes_.back(), nodes_.back()));
                }
            }
        }
        tree_ = BoxTree(boxes);
    }

    const std::vector<Vec2> &all() const { return nodes_; }

    /// Returns true if one of them is within a distance.
    bool near(Vec2 place, double limit) const {
        double nearest = std::numeric_limits<double>::infinity();
        tree_.nearest(place, nearest, [&](std::uint32_t k) { return distance(place, nodes_[k]); });
        return nearest <= limit;
    }

  private:
    std::vector<Vec2> nodes_;
    BoxTree tree_;
};

std::size_t lostIn(const Arrangement &arrangement) {
    std::size_t count = 0;
    for (const ArrangementChange &change : arrangement.changes) {
        const bool loses = change.kind == ChangeKind::ShortPieces || change.kind == ChangeKind::VanishedShapes;
        count += loses ? change.count : 0;
    }
    return count;
}

/// Returns the outline that lines bound once they are joined, if it passes through the ends that were apart.
std::optional<OpenOutline> closedBy(const LineGaps &gaps, const Domain &lines, std::size_t boundary, Domain joined,
                                    double tolerance) {
    if (takeLinesAsOutline(joined).segments <= boundary) {
        return std::nullopt;
    }
    const BoundaryNodes before(lines), after(joined);
    OpenOutline open;
    std::size_t ends = 0;
    for (const NearEnd &end : gaps.ends) {
        if (!after.near(end.at, 1.001 * tolerance) || before.near(end.at, tolerance)) {
            continue;
        }
        if (ends++ == 0) {
            open.at = end.at;
            open.segment = end.segment;
        }
        open.gap = std::max(open.gap, end.gap);
    }
    if (ends == 0) {
        return std::nullopt;
    }
    open.gaps = (ends + 1) / 2;
    open.outer = reachesBeyond(boxOfNodes(after.all()), boxOfNodes(before.all()));
    return open;
}

/// A line from one free end to another, without branches.
struct OpenChain {
    std::vector<Vec2> nodes;
    double length = 0.0;
    std::size_t segment = 0; ///< the first one

    bool nearlyCloses() const { return nodes.size() > 2 && distance(nodes.front(), nodes.back()) < 0.5 * length; }

    /// Returns true if the line, closed, has a place inside.
    bool encloses(Vec2 p) const {
        bool inside = false;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const Vec2 a = nodes[k], b = nodes[(k + 1) % nodes.size()];
            const bool upward = a.y <= p.y && b.y > p.y, downward = b.y <= p.y && a.y > p.y;
            if ((upward || downward) && (orientation(a, b, p) > 0) == upward) {
                inside = !inside;
            }
        }
        return inside;
    }
};

/// Walks along the lines of a domain.
class OpenChains {
  public:
    explicit OpenChains(const Domain &domain)
        : domain_(domain), around_(domain.nodes.size(), [&](const auto &add) {
              for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
                  add(domain.segments[s].a, s);
                  add(domain.segments[s].b, s);
              }
          }) {}

    /// Returns the chain that begins at a node; without nodes if that is no free end, or a branch follows.
    OpenChain from(std::uint32_t start) const {
        OpenChain chain;
        if (around_[start].size() != 1) {
            return chain;
        }
        chain.segment = around_[start][0];
        chain.nodes.push_back(domain_.nodes[start]);
        std::uint32_t node = start, s = around_[start][0];
        for (;;) {
            node = domain_.segments[s].a == node ? domain_.segments[s].b : domain_.segments[s].a;
            chain.length += distance(chain.nodes.back(), domain_.nodes[node]);
            chain.nodes.push_back(domain_.nodes[node]);
            const auto here = around_[node];
            if (here.size() != 2) {
                return here.size() == 1 ? chain : OpenChain{};
            }
            s = here[0] == s ? here[1] : here[0];
        }
    }

  private:
    const Domain &domain_;
    Rows<std::uint32_t> around_; ///< segments by node
};

} // namespace

GapFindings examineGaps(const ArrangementInput &input, const Arrangement &lines, std::size_t boundary) {
    constexpr double kSteps[] = {1.0, 0.1, 0.01};
    constexpr std::size_t kMost = 1000; // ends; more are those of hatching, and trials would take long
    const double near = kNearEnds * lines.domain.bounds().diagonal();
    GapFindings found{findLineGaps(lines.domain, near), 0.0, std::nullopt};
    if (found.gaps.count == 0) {
        return found;
    }
    for (const double step : kSteps) {
        LineGaps gaps = findLineGaps(lines.domain, step * near);
        if (gaps.count == 0 || gaps.count > kMost) {
            continue;
        }
        ArrangementInput trial = input;
        trial.tolerance = kGapSpare * gaps.widest;
        Result<Arrangement> joined = arrange(trial);
        if (!joined) {
            continue;
        }
        const bool joins = findLineGaps(joined->domain, step * near).count == 0 && lostIn(*joined) <= lostIn(lines);
        std::optional<OpenOutline> open =
            closedBy(gaps, lines.domain, boundary, std::move(joined->domain), trial.tolerance);
        if (open && !found.open) {
            found.open = open;
        }
        if (joins && (open || !found.open)) { // the rest of the gaps may keep an outline open
            return {std::move(gaps), trial.tolerance, open};
        }
    }
    return found;
}

std::optional<OpenOutline> findOpenOutline(const Domain &domain) {
    const OpenChains chains(domain);
    OpenChain largest;
    for (std::uint32_t node = 0; node < domain.nodes.size(); ++node) {
        OpenChain chain = chains.from(node);
        if (chain.nearlyCloses() && boxArea(boxOfNodes(chain.nodes)) > boxArea(boxOfNodes(largest.nodes))) {
            largest = std::move(chain);
        }
    }
    const std::vector<Vec2> boundary = BoundaryNodes(domain).all();
    if (largest.nodes.empty() || !reachesBeyond(boxOfNodes(largest.nodes), boxOfNodes(boundary)) ||
        std::none_of(boundary.begin(), boundary.end(), [&](Vec2 p) { return largest.encloses(p); })) {
        return std::nullopt;
    }
    return OpenOutline{largest.nodes.front(), distance(largest.nodes.front(), largest.nodes.back()), 1, largest.segment,
                       true};
}

std::string openOutlineText(const OpenOutline &open, double weld) {
    std::string text = (open.outer ? "the outline" : "an inner outline") + std::string(" does not close at ") +
                       placeText(open.at) + " by " + numberText(open.gap, 3);
    if (open.gaps > 1) {
        text +=
            open.gaps == 2 ? ", nor at another place" : ", nor at " + std::to_string(open.gaps - 1) + " other places";
    }
    text += open.outer ? ", so the area within it is not meshed" : ", so it bounds neither a hole nor a part";
    return text + (weld > 0.0 ? "; --weld " + numberText(weld, 3) + " closes it" : "; close it in the drawing");
}

} // namespace forefront
