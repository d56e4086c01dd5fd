#include "core/engine/strips/widened_domain.hpp"

#include "core/engine/base/ids.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/engine/domain/validate.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "core/engine/strips/strip_ends.hpp"
#include "core/engine/strips/strip_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace forefront {

namespace {

constexpr double kMitreLimit = 4.0;    ///< length of a mitre in widths of its strip
constexpr double kMostAtCurve = 5.0;   ///< degrees of a corner at the end of a curve
constexpr double kShortestSide = 1e-3; ///< of a straight part, relative to the part

/// A strip while it is made: numbers of the draft.
struct StripSketch {
    std::size_t spec = 0;
    StripFace face;
    std::vector<std::uint32_t> ends; ///< segments across its ends
    Vec2 inside;
};

/// The nodes on the two sides of a strip where its line has a node.
struct StripJoint {
    std::uint32_t left = 0, right = 0;
};

/// Makes the sides of one line of a strip.
class SideBuilder {
  public:
    SideBuilder(StripDraft &draft, const StripSpec &spec, const StripLine &line)
        : draft_(draft), spec_(spec), line_(line) {}

    Status run(double growth, std::vector<SizeSite> &sites, StripSketch &sketch) {
        const std::size_t runs = line_.runs.size();
        std::vector<StripJoint> joints(runs + 1);
        for (std::size_t k = line_.closed ? 0 : 1; k < runs; ++k) {
            if (Status faults = addJoint(k, joints[k]); !faults.empty()) {
                return faults;
            }
        }
        joints[runs] = joints[0]; // of a closed line
        for (const bool start : {true, false}) {
            if (line_.closed) {
                break;
            }
            Result<StripEnd> end = addStripEnd(draft_, spec_, line_, start, growth, sites);
            if (!end) {
                return end.faults();
            }
            joints[start ? 0 : runs] = {end->left, end->right};
            sketch.ends.insert(sketch.ends.end(), end->segments.begin(), end->segments.end());
        }
        for (std::size_t k = 0; k < runs; ++k) {
            StripPiece &piece = sketch.face.pieces.emplace_back();
            for (const bool left : {true, false}) {
                if (Status faults = addSide(k, left, joints[k], joints[k + 1], left ? piece.left : piece.right);
                    !faults.empty()) {
                    return faults;
                }
            }
        }
        sketch.face.corners = {joints[0].right, joints[0].left, joints[runs].right, joints[runs].left};
        const SideRun &first = line_.runs.front();
        sketch.inside = first.straight() ? middleOf(joints[0], joints[1]) : first.curve.point(0.5);
        return {};
    }

  private:
    Status bend(const std::string &what, const char *advice, Vec2 at) const {
        return stripError("strip-bend", draft_.domain, spec_.tag, what, advice, at);
    }
    Vec2 at(std::uint32_t node) const { return draft_.domain.nodes[node]; }
    Vec2 middleOf(const StripJoint &a, const StripJoint &b) const {
        return midpoint(midpoint(at(a.left), at(a.right)), midpoint(at(b.left), at(b.right)));
    }

    /// Adds the nodes where the sides of a run meet those of the run before it: a mitre.
    Status addJoint(std::size_t k, StripJoint &joint) {
        const SideRun &before = line_.runs[(k + line_.runs.size() - 1) % line_.runs.size()], &after = line_.runs[k];
        const Vec2 a = before.curve.tangent(1.0), b = after.curve.tangent(0.0), place = after.start();
        const double turn = std::atan2(cross(a, b), dot(a, b)), degrees = std::abs(turn) * 180.0 / std::numbers::pi;
        if (std::cos(0.5 * turn) * kMitreLimit < 1.0) {
            return bend("its line turns by " + numberText(degrees, 3) +
                            " degrees, so that its corner would be more "
                            "than " +
                            numberText(kMitreLimit, 2) + " widths long",
                        "make the corner blunter or round, or divide the line there", place);
        }
        if (!(before.straight() && after.straight()) && degrees > kMostAtCurve) {
            return bend("its line has a corner of " + numberText(degrees, 3) + " degrees at the end of a curve",
                        "make the curve tangent to the line beside it, or divide the line there", place);
        }
        const Vec2 sum = a + b;
        const Vec2 arm = (0.5 * spec_.width / std::cos(0.5 * turn) / length(sum)) * leftNormal(sum);
        joint = {draft_.addNode(place + arm), draft_.addNode(place - arm)};
        return {};
    }

    Status addSide(std::size_t k, bool left, const StripJoint &begin, const StripJoint &end,
                   std::vector<std::uint32_t> &segments) {
        const SideRun &run = line_.runs[k];
        const std::uint32_t from = left ? begin.left : begin.right, to = left ? end.left : end.right;
        const DomainSegment like{from, to, spec_.tag, SegmentRole::Constraint, {}};
        const Vec2 tooShort = run.curve.point(0.5);
        if (run.straight()) {
            const Vec2 along = run.end() - run.start();
            if (!(dot(at(to) - at(from), along) > kShortestSide * lengthSquared(along))) {
                return bend("a part of its line is too short for its width", "choose a smaller width, or longer parts",
                            tooShort);
            }
            segments = {draft_.addSegment(like, run.elements)};
            draft_.biases[segments.front()] = run.bias;
            return {};
        }
        const auto parameter = [&](bool atEnd, std::uint32_t node) {
            const bool trimmed = !line_.closed && k == (atEnd ? line_.runs.size() - 1 : 0);
            return trimmed ? run.curve.nearest(at(node)) : atEnd ? 1.0 : 0.0;
        };
        const double t0 = parameter(false, from), t1 = parameter(true, to);
        const std::optional<Curve> side =
            t0 < t1 ? parallelTo(run.curve.part(t0, t1), left ? 0.5 * spec_.width : -0.5 * spec_.width) : std::nullopt;
        if (!side) {
            return bend("a part of its line is too short for its width", "choose a smaller width, or longer parts",
                        tooShort);
        }
        segments = draft_.addCurve(joining(*side, at(from), at(to)), run.chords, from, to, like, run.elements);
        for (const std::uint32_t s : segments) {
            draft_.biases[s] = run.bias;
        }
        return {};
    }

    StripDraft &draft_;
    const StripSpec &spec_;
    const StripLine &line_;
};

class Widener {
  public:
    Widener(const Domain &domain, std::span<const StripSpec> specs, const SegmentElements &elements, double growth)
        : given_(domain), specs_(specs), elements_(elements), growth_(growth), draft_(domain, elements) {}

    Result<WidenedDomain> run() {
        if (Status faults = findLines(); !faults.empty()) {
            return faults;
        }
        for (std::size_t i = 0; i < specs_.size(); ++i) {
            const std::int32_t region = regionOf(specs_[i]);
            for (const StripLine &line : lines_[i]) {
                StripSketch &sketch = sketches_.emplace_back();
                sketch.spec = i;
                sketch.face.tag = specs_[i].tag;
                sketch.face.rows = specs_[i].rows;
                sketch.face.cells = specs_[i].cells;
                sketch.face.closed = line.closed;
                if (Status faults = SideBuilder(draft_, specs_[i], line).run(growth_, result_.ends, sketch);
                    !faults.empty()) {
                    return faults;
                }
                draft_.domain.regionMarkers.push_back({sketch.inside, region});
            }
        }
        finish();
        if (Status faults = check(); !faults.empty()) {
            return faults;
        }
        return std::move(result_);
    }

  private:
    Status error(std::size_t spec, const char *code, const std::string &what, const char *advice, Vec2 at) const {
        return stripError(code, given_, specs_[spec].tag, what, advice, at);
    }

    /// Finds the lines of all strips and removes their segments.
    Status findLines() {
        std::map<std::int32_t, std::size_t> ofTag;
        for (std::size_t i = 0; i < specs_.size(); ++i) {
            ofTag[specs_[i].tag] = i;
        }
        for (std::size_t i = 0; i < specs_.size(); ++i) {
            Result<std::vector<StripLine>> lines = stripLines(given_, specs_[i], elements_);
            if (!lines) {
                return lines.faults();
            }
            for (const StripLine &line : *lines) {
                for (const std::uint32_t node : {line.first, line.last}) {
                    for (const std::uint32_t s : draft_.at(node)) {
                        const std::int32_t tag = given_.segments[s].tag;
                        if (tag != specs_[i].tag && ofTag.contains(tag)) {
                            return error(i, "strip-meets",
                                         "the strip " + boundaryName(given_.boundaryNames, tag) + " meets it",
                                         "end one of them beside the other", given_.nodes[node]);
                        }
                    }
                }
            }
            lines_.push_back(std::move(*lines));
        }
        for (std::uint32_t s = 0; s < given_.segments.size(); ++s) {
            if (ofTag.contains(given_.segments[s].tag)) {
                draft_.remove(s);
            }
        }
        return {};
    }

    /// Returns the tag of the region of a strip, and names it.
    std::int32_t regionOf(const StripSpec &spec) {
        if (spec.region > 0) {
            return spec.region;
        }
        Domain &domain = draft_.domain;
        std::set<std::int32_t> taken{1};
        std::set<std::string> names;
        for (const RegionMarker &marker : domain.regionMarkers) {
            taken.insert(marker.tag);
        }
        for (const auto &[tag, name] : domain.regionNames) {
            names.insert(name);
        }
        for (const StripSpec &other : specs_) {
            taken.insert(other.region);
        }
        const std::int32_t tag = unusedTag(taken, domain.regionNames, TagKind::Region);
        const std::string line = boundaryName(domain.boundaryNames, spec.tag);
        std::string name = line;
        for (int k = 2; names.contains(name); ++k) {
            name = line + '_' + std::to_string(k);
        }
        domain.regionNames[tag] = name;
        return tag;
    }

    void finish() {
        std::vector<std::uint32_t> numbers, nodes;
        result_.domain = draft_.finished(numbers, nodes);
        result_.elements = std::move(draft_.elements);
        result_.biases = std::move(draft_.biases);
        const auto renumber = [&](std::vector<std::uint32_t> &segments) {
            for (std::uint32_t &s : segments) {
                s = numbers[s];
            }
        };
        for (StripSketch &sketch : sketches_) {
            for (StripPiece &piece : sketch.face.pieces) {
                renumber(piece.left);
                renumber(piece.right);
            }
            renumber(sketch.ends);
            for (std::uint32_t &node : sketch.face.corners) {
                node = nodes[node];
            }
        }
    }

    Status check() {
        const Diagnostics faults = validate(result_.domain, kMaxListedFaults, &result_.faces);
        for (const Diagnostic &fault : faults) {
            if (fault.severity == Severity::Error) {
                return noRoom(fault);
            }
        }
        for (StripSketch &sketch : sketches_) {
            if (Status within = checkFace(sketch); !within.empty()) {
                return within;
            }
        }
        const std::vector<std::uint8_t> &inside = result_.faces.labels.inside;
        for (StripSketch &sketch : sketches_) {
            StripFace &face = sketch.face;
            face.region = static_cast<std::uint32_t>(std::count(inside.begin(), inside.begin() + face.face, 1));
            result_.strips.push_back(std::move(face));
        }
        return {};
    }

    /// Returns the error for a fault that the strips have made.
    Status noRoom(const Diagnostic &fault) const {
        std::size_t spec = sketches_.front().spec;
        bool marker = fault.code == "region-marker-conflict" || fault.code == "region-marker-outside";
        for (const DomainPart &part : fault.parts) {
            if (part.kind == DomainPartKind::Segment) {
                const std::int32_t tag = result_.domain.segments[part.index].tag;
                const auto found = std::ranges::find(specs_, tag, &StripSpec::tag);
                spec = found == specs_.end() ? spec : static_cast<std::size_t>(found - specs_.begin());
            } else if (part.kind == DomainPartKind::RegionMarker && part.index >= given_.regionMarkers.size()) {
                spec = sketches_[part.index - given_.regionMarkers.size()].spec;
            }
        }
        const Vec2 at = fault.at.value_or(sketches_.front().inside);
        if (marker) {
            return error(spec, "strip-room", "the place of a region lies inside it",
                         "move the place of the region out of the strip", at);
        }
        return error(spec, "strip-room",
                     "its width of " + numberText(specs_[spec].width, 6) +
                         " does not fit: it meets itself, another strip or another line",
                     "choose a smaller width, or move the lines apart", at);
    }

    /// Finds the face of a strip, which must be empty.
    Status checkFace(StripSketch &sketch) const {
        const DomainFaces &faces = result_.faces;
        const Domain &domain = result_.domain;
        const std::uint32_t own = sketch.face.face = faces.faces.left[sketch.face.pieces.front().right.front()];
        std::set<std::uint32_t> sides(sketch.ends.begin(), sketch.ends.end());
        bool oriented = faces.labels.inside[own] != 0;
        for (const StripPiece &piece : sketch.face.pieces) {
            sides.insert(piece.left.begin(), piece.left.end());
            sides.insert(piece.right.begin(), piece.right.end());
            const auto bounds = [&](const std::vector<std::uint32_t> &of, std::uint32_t s) { return of[s] == own; };
            oriented = oriented && bounds(faces.faces.right, piece.left.front()) &&
                       bounds(faces.faces.left, piece.right.front());
        }
        const char *const advice = "choose a smaller width, or move what lies inside";
        if (!oriented) {
            return error(sketch.spec, "strip-room", "its width does not fit", advice, sketch.inside);
        }
        for (std::uint32_t s = 0; s < domain.segments.size(); ++s) {
            if ((faces.faces.left[s] == own || faces.faces.right[s] == own) && !sides.contains(s)) {
                return error(sketch.spec, "strip-room",
                             "the line " + boundaryName(domain.boundaryNames, domain.segments[s].tag) +
                                 " lies inside it",
                             advice, midpoint(domain.nodes[domain.segments[s].a], domain.nodes[domain.segments[s].b]));
            }
        }
        for (const ConstraintPoint &point : domain.points) {
            if (faces.faces.ofPoint[point.node] == own) {
                return error(sketch.spec, "strip-room", "a point lies inside it", advice, domain.nodes[point.node]);
            }
        }
        return {};
    }

    const Domain &given_;
    std::span<const StripSpec> specs_;
    const SegmentElements &elements_;
    double growth_;
    StripDraft draft_;
    std::vector<std::vector<StripLine>> lines_; ///< per specification
    std::vector<StripSketch> sketches_;
    WidenedDomain result_;
};

} // namespace

Result<WidenedDomain> widenedDomain(const Domain &domain, std::span<const StripSpec> specs,
                                    const SegmentElements &elements, double growth) {
    return Widener(domain, specs, elements, growth).run();
}

Status widenStrips(std::span<const StripSpec> specs, std::span<const std::int32_t> cracks,
                   std::span<const PeriodicSpec> periodic, Domain &domain, std::vector<std::uint32_t> &elements,
                   std::vector<ElementBias> &biases) {
    if (specs.empty()) {
        return {};
    }
    DomainFaces faces;
    Diagnostics faults = validate(domain, kMaxListedFaults, &faces);
    if (!hasErrors(faults)) {
        faults = checkStrips(specs, domain, faces, cracks, periodic);
    }
    if (hasErrors(faults)) {
        return faults;
    }
    Result<WidenedDomain> widened = widenedDomain(domain, specs, SegmentElements(elements, biases), 0.0);
    if (!widened) {
        return widened.faults();
    }
    domain = std::move(widened->domain);
    elements = std::move(widened->elements);
    biases = std::move(widened->biases);
    return {};
}

} // namespace forefront
