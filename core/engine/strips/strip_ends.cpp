#include "core/engine/strips/strip_ends.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr double kMostOblique = 25.0; ///< degrees between a strip and a line on which it ends
constexpr double kStraightOn = 1e-9;  ///< sine of the angle below which two segments are one line
constexpr double kSameNode = 1e-6;    ///< distance below which a cut is a node, relative to the width
constexpr int kBisections = 60;       ///< of a segment, for a cut

/// The part of a line between the node where a strip ends and a side of the strip.
struct StripArm {
    std::uint32_t segment = 0;           ///< the first segment, as it was
    DomainSegment like;                  ///< its tag and role
    std::vector<std::uint32_t> inside;   ///< segments that lie in the end of the strip, from the node on
    std::vector<CurveStretch> stretches; ///< of them, in that direction
    std::uint32_t corner = 0;            ///< node on the side
    double length = 0.0;
    std::uint32_t curve() const { return stretches.front().curve; }
};

class EndBuilder {
  public:
    EndBuilder(StripDraft &draft, const StripSpec &spec, const StripLine &line, bool start, double growth,
               std::vector<SizeSite> &sites)
        : draft_(draft), spec_(spec), start_(start), growth_(growth), sites_(sites), half_(0.5 * spec.width),
          node_(start ? line.first : line.last), curve_(start ? line.runs.front().curve : line.runs.back().curve) {
        if (!start) {
            curve_ = curve_.kind() == CurveKind::Line ? Curve::line(curve_.point(1.0), curve_.point(0.0))
                                                      : curve_.part(1.0, 0.0);
        }
        at_ = draft.domain.nodes[node_];
        into_ = curve_.tangent(0.0);
    }

    Result<StripEnd> run() {
        const std::vector<std::pair<double, std::uint32_t>> others = linesByAngle();
        if (others.empty()) {
            return flat({});
        }
        if (others.size() == 1) {
            return flat(others.front());
        }
        StripArm left, right;
        if (Status faults = cut(others.front(), true, left); !faults.empty()) {
            return faults;
        }
        if (Status faults = cut(others.back(), false, right); !faults.empty()) {
            return faults;
        }
        if (Status faults = divide(others.size(), left, right); !faults.empty()) {
            return faults;
        }
        return seenAlong(left.corner, right.corner);
    }

  private:
    Status fault(const std::string &what, const char *advice, Vec2 at) const {
        return stripError("strip-end", draft_.domain, spec_.tag, what, advice, at);
    }
    std::string nameOf(std::uint32_t s) const {
        return boundaryName(draft_.domain.boundaryNames, draft_.domain.segments[s].tag);
    }
    /// Returns the corners as they are seen along the strip; here, they are seen into it.
    StripEnd seenAlong(std::uint32_t left, std::uint32_t right) {
        return start_ ? StripEnd{left, right, std::move(added_)} : StripEnd{right, left, std::move(added_)};
    }

    /// Returns the segments that meet the end, with their angles counter-clockwise from the strip.
    std::vector<std::pair<double, std::uint32_t>> linesByAngle() const {
        std::vector<std::pair<double, std::uint32_t>> lines;
        for (const std::uint32_t s : draft_.at(node_)) {
            const Vec2 e = draft_.domain.nodes[draft_.otherEnd(s, node_)] - at_;
            const double angle = std::atan2(cross(into_, e), dot(into_, e)) * 180.0 / std::numbers::pi;
            lines.emplace_back(angle < 0.0 ? angle + 360.0 : angle, s);
        }
        std::sort(lines.begin(), lines.end());
        return lines;
    }

    /// Adds the end of a strip inside the domain; another line may go on from its middle.
    Result<StripEnd> flat(const std::optional<std::pair<double, std::uint32_t>> &line) {
        const Vec2 arm = half_ * leftNormal(into_);
        if (line && !(line->first > 90.0 + kMostOblique && line->first < 270.0 - kMostOblique)) {
            return fault("the line " + nameOf(line->second) + " meets its end from the side",
                         "end the other line beside the strip", at_);
        }
        if (line && spec_.rows % 2 != 0) {
            return fault("the line " + nameOf(line->second) + " meets the middle of its end, where " +
                             countText(spec_.rows, "row") + " have no node",
                         "choose an even number of rows", at_);
        }
        const std::uint32_t left = draft_.addNode(at_ + arm), right = draft_.addNode(at_ - arm);
        const DomainSegment like{0, 0, spec_.tag, SegmentRole::Constraint, {}};
        if (line) {
            addLine(right, node_, like, spec_.rows / 2, true);
            addLine(node_, left, like, spec_.rows / 2, true);
        } else {
            addLine(right, left, like, spec_.rows, true);
        }
        return seenAlong(left, right);
    }

    void addLine(std::uint32_t from, std::uint32_t to, DomainSegment like, std::uint32_t count, bool inner) {
        like.a = from;
        like.b = to;
        like.stretch = {};
        added_.push_back(draft_.addSegment(like, count));
        if (inner) {
            const Vec2 a = draft_.domain.nodes[from], b = draft_.domain.nodes[to];
            sites_.push_back(SizeSite::segment(a, b, distance(a, b) / count, growth_));
        }
    }

    /// Returns how far a place is beyond a side of the strip.
    double beyond(Vec2 p, bool left) const {
        double t = 0.0;
        if (curve_.kind() != CurveKind::Line) {
            t = curve_.nearest(p);
        }
        const double off = cross(curve_.tangent(t), p - curve_.point(t));
        return (left ? off : -off) - half_;
    }

    /// Follows a line from the end to a side of the strip, and cuts it there.
    Status cut(std::pair<double, std::uint32_t> line, bool left, StripArm &arm) {
        const double angle = left ? line.first : 360.0 - line.first;
        std::uint32_t s = line.second, node = node_;
        if (!(angle >= kMostOblique && angle <= 180.0 - kMostOblique)) {
            return fault("it meets the line " + nameOf(s) + " at " + numberText(angle, 3) + " degrees; expected " +
                             numberText(kMostOblique, 3) + " to " + numberText(180.0 - kMostOblique, 3),
                         "end the strip inside the domain, or more nearly square to the line", at_);
        }
        arm.segment = s;
        arm.like = draft_.domain.segments[s];
        for (;;) {
            const std::uint32_t next = draft_.otherEnd(s, node);
            if (draft_.elements[s] > 0) {
                return fault("it ends on " + nameOf(s) + ", which has a number of elements of its own",
                             "leave out that number, or end the strip elsewhere", at_);
            }
            if (beyond(draft_.domain.nodes[next], left) > -kSameNode * spec_.width) {
                cutSegment(s, node, next, left, arm);
                return {};
            }
            const std::optional<std::uint32_t> onward = continuation(s, next);
            if (!onward) {
                return fault("the line " + nameOf(s) + " on which it ends is too short for its width",
                             "choose a smaller width, or end the strip farther from the corner",
                             draft_.domain.nodes[next]);
            }
            arm.inside.push_back(s);
            arm.stretches.push_back(stretchFrom(s, node));
            arm.length += distance(draft_.domain.nodes[node], draft_.domain.nodes[next]);
            node = next;
            s = *onward;
        }
    }

    CurveStretch stretchFrom(std::uint32_t s, std::uint32_t node) const {
        const DomainSegment &segment = draft_.domain.segments[s];
        return segment.a == node ? segment.stretch : segment.stretch.reversed();
    }

    /// Returns the segment that continues a curve beyond a node where nothing else meets.
    std::optional<std::uint32_t> continuation(std::uint32_t s, std::uint32_t node) const {
        const std::vector<std::uint32_t> &around = draft_.at(node);
        if (around.size() != 2 || draft_.isPoint(node)) {
            return std::nullopt;
        }
        const std::uint32_t next = around.front() == s ? around.back() : around.front();
        const DomainSegment &a = draft_.domain.segments[s], &b = draft_.domain.segments[next];
        const bool same =
            a.stretch.follows() && a.stretch.curve == b.stretch.curve && a.tag == b.tag && a.role == b.role;
        return same ? std::optional(next) : std::nullopt;
    }

    void cutSegment(std::uint32_t s, std::uint32_t node, std::uint32_t next, bool left, StripArm &arm) {
        const CurveStretch stretch = stretchFrom(s, node);
        const Vec2 a = draft_.domain.nodes[node], b = draft_.domain.nodes[next];
        const auto place = [&](double u) {
            return stretch.follows()
                       ? draft_.domain.curves[stretch.curve].point(stretch.t0 + u * (stretch.t1 - stretch.t0))
                       : lerp(a, b, u);
        };
        double low = 0.0, high = 1.0;
        for (int k = 0; k < kBisections; ++k) {
            const double middle = 0.5 * (low + high);
            (beyond(place(middle), left) > 0.0 ? high : low) = middle;
        }
        if (distance(place(high), b) <= kSameNode * spec_.width) { // a node of the domain is the corner
            arm.corner = next;
            arm.inside.push_back(s);
            arm.stretches.push_back(stretch);
            arm.length += distance(a, b);
            return;
        }
        const double t = stretch.t0 + high * (stretch.t1 - stretch.t0);
        arm.corner = draft_.addNode(place(high));
        arm.length += distance(a, draft_.domain.nodes[arm.corner]);
        DomainSegment inside = arm.like;
        inside.a = node;
        inside.b = arm.corner;
        inside.stretch = stretch.follows() ? CurveStretch{stretch.curve, stretch.t0, t} : CurveStretch{};
        draft_.moveEnd(s, node, arm.corner);
        DomainSegment &rest = draft_.domain.segments[s];
        if (stretch.follows()) {
            (rest.a == arm.corner ? rest.stretch.t0 : rest.stretch.t1) = t;
        }
        arm.inside.push_back(draft_.addSegment(inside, 0));
        arm.stretches.push_back(inside.stretch);
    }

    /// Replaces the arms by lines with numbers of elements that are the rows of the strip.
    Status divide(std::size_t lines, const StripArm &left, const StripArm &right) {
        const bool alike = lines == 2 && !draft_.isPoint(node_) && left.like.tag == right.like.tag &&
                           left.like.role == right.like.role && left.curve() == right.curve();
        const Vec2 l = draft_.domain.nodes[left.corner], r = draft_.domain.nodes[right.corner];
        const bool inner = left.like.role == SegmentRole::Constraint;
        const bool curved = alike && left.stretches.front().follows() &&
                            left.stretches.front().t0 == right.stretches.front().t0 &&
                            (left.stretches.back().t1 < left.stretches.front().t0) !=
                                (right.stretches.back().t1 < right.stretches.front().t0);
        const bool straight = alike && !left.stretches.front().follows() &&
                              std::abs(cross(l - at_, r - at_)) <= kStraightOn * distance(l, at_) * distance(r, at_);
        if (curved || straight) {
            const CurveStretch whole{left.curve(), right.stretches.back().t1, left.stretches.back().t1};
            removeArms(left, right);
            addPart(right.corner, left.corner, left.like, whole, left.inside.size() + right.inside.size(), spec_.rows,
                    inner);
            return {};
        }
        if (spec_.rows < 2) {
            return fault("it ends at a corner or at another line, where one row has no node",
                         "choose two rows or more, or end the strip elsewhere", at_);
        }
        const double share = spec_.rows * left.length / (left.length + right.length);
        const auto ofLeft = static_cast<std::uint32_t>(std::clamp(std::round(share), 1.0, spec_.rows - 1.0));
        removeArms(left, right);
        const auto whole = [](const StripArm &arm) {
            return CurveStretch{arm.curve(), arm.stretches.front().t0, arm.stretches.back().t1};
        };
        addPart(node_, left.corner, left.like, whole(left), left.inside.size(), ofLeft, inner);
        addPart(node_, right.corner, right.like, whole(right), right.inside.size(), spec_.rows - ofLeft, inner);
        return {};
    }

    void removeArms(const StripArm &left, const StripArm &right) {
        for (const StripArm *const arm : {&left, &right}) {
            for (const std::uint32_t s : arm->inside) {
                draft_.remove(s);
            }
        }
    }

    void addPart(std::uint32_t from, std::uint32_t to, const DomainSegment &like, const CurveStretch &stretch,
                 std::size_t chords, std::uint32_t count, bool inner) {
        if (!stretch.follows()) {
            addLine(from, to, like, count, inner);
            return;
        }
        const Curve part = draft_.domain.curves[stretch.curve].part(stretch.t0, stretch.t1);
        const std::vector<std::uint32_t> along =
            draft_.addCurve(part, static_cast<std::uint32_t>(std::max<std::size_t>(chords, 2)), from, to, like, count);
        added_.insert(added_.end(), along.begin(), along.end());
        if (inner) {
            const Vec2 a = draft_.domain.nodes[from], b = draft_.domain.nodes[to];
            sites_.push_back(SizeSite::segment(a, b, part.length() / count, growth_));
        }
    }

    StripDraft &draft_;
    const StripSpec &spec_;
    bool start_;
    double growth_;
    std::vector<SizeSite> &sites_;
    double half_;
    std::uint32_t node_;
    Curve curve_; ///< of the line, from the end into the strip
    Vec2 at_, into_;
    std::vector<std::uint32_t> added_; ///< segments of the end
};

} // namespace

Result<StripEnd> addStripEnd(StripDraft &draft, const StripSpec &spec, const StripLine &line, bool start, double growth,
                             std::vector<SizeSite> &sites) {
    return EndBuilder(draft, spec, line, start, growth, sites).run();
}

} // namespace forefront
