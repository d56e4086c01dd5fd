#include "core/drawing_files/common/drawing_builder.hpp"
#include "core/drawing_files/svg/areas/svg_background.hpp"
#include "core/drawing_files/svg/areas/svg_ends.hpp"
#include "core/drawing_files/svg/areas/svg_regions.hpp"
#include "core/drawing_files/svg/areas/svg_repeats.hpp"
#include "core/drawing_files/svg/areas/svg_roles.hpp"
#include "core/drawing_files/svg/areas/svg_stroke_areas.hpp"
#include "core/drawing_files/svg/areas/svg_white.hpp"
#include "core/drawing_files/svg/drawing/svg_drawing.hpp"
#include "core/drawing_files/svg/svg.hpp"
#include "core/drawing_files/svg/xml/svg_names.hpp"
#include "core/files/common/tag_allocator.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

constexpr double kMaxStroke = 1.0 / 16.0; ///< of the drawing size: the widest stroke that may repeat an outline

class SvgBuilder {
  public:
    SvgBuilder(SvgPaths drawing, const SourceText &source)
        : source_(source), paths_(std::move(drawing.paths)), clips_(std::move(drawing.clips)), builder_(source),
          strokes_(builder_, drawing.size, drawing.tolerance, source.options.shapeRegions), size_(drawing.size) {
        // A path of a single node that is not closed was never drawn; other paths may end up as dots.
        std::erase_if(paths_, [](const SvgPath &path) { return path.nodes.size() < 2 && !path.closed; });
        for (SvgPath &path : paths_) {
            if (path.painted() || !path.strokeArea) { // a stroke may turn back where two nodes are left
                joinEnds(path, drawing.size);
            }
        }
        for (SvgClip &clip : clips_) {
            for (SvgPath &part : clip.parts) {
                joinEnds(part, drawing.size);
            }
        }
        for (const SvgPath &path : paths_) {
            regions_.reserve(path.name);
        }
        roles_.emplace(source, paths_, drawing.cropsFill);
    }

    Result<Domain> run() {
        dropRepeatedOutlines();
        const std::uint32_t feature = builder_.addFeature(1);
        chooseRules();
        const SvgWhiteShapes white(paths_);
        source_.reportContents(contents(white.count()));
        noteWhite(white);
        addClips();
        for (SvgPath &path : paths_) {
            const auto index = static_cast<std::size_t>(&path - paths_.data());
            if (makesHoles() && white.contains(index)) {
                addHole(path, white.below(index));
                continue;
            }
            const PathRole part = roles_->of(path);
            const std::int32_t tag = part == PathRole::Nothing ? 0 : tags_.of(path.name);
            builder_.from({path.offset});
            roles_->noteReading(path, part);
            if (path.strokeArea) {
                if (!strokes_.add(path, shapeOf(feature, path), tag)) {
                    return Diagnostics{faultAt(source_, path.offset, "too-large", "the strokes need too many nodes",
                                               "leave out strokes or dashes, or read strokes as lines")};
                }
            }
            if (part != PathRole::Stroke) {
                builder_.addCurves(path.curves, path.stretches); // renumbers the stretches
            }
            switch (part) {
            case PathRole::Painted:
                if (painted_ != path.element) {
                    painted_ = path.element;
                    const std::uint32_t shape = shapeOf(feature, path);
                    contour_ = builder_.addContour(shape, path.paint.rule);
                    shapes_.emplace(path.element, shape);
                }
                builder_.addRing(contour_, path.nodes, tag, path.stretches);
                if (path.paint.stroked && !path.strokeArea && !path.closed && !source_.options.dropLines) {
                    builder_.addChain(path.nodes, tag, path.stretches, path.limit, widthOf(path));
                }
                break;
            case PathRole::Outline:
                builder_.addRing(outlineContour(feature, path.limit), path.nodes, tag, path.stretches);
                break;
            case PathRole::Line:
                addLine(path, tag);
                break;
            case PathRole::Stroke:
            case PathRole::LeftOut:
            case PathRole::Nothing:
                break;
            }
        }
        strokes_.finish(feature);
        Result<Domain> domain = builder_.finish();
        if (domain) {
            domain->boundaryNames = usedNames(*domain);
            domain->regionNames = regions_.namesIn(*domain);
            domain->curveTolerance = source_.options.curveTolerance;
        }
        return domain;
    }

    /// Returns the paths as shapes that share no nodes.
    Result<Domain> runApart() {
        dropRepeatedOutlines();
        std::vector<PathRole> parts;
        for (const SvgPath &path : paths_) {
            parts.push_back(roles_->of(path));
        }
        const auto isArea = [](PathRole part) { return part == PathRole::Painted || part == PathRole::Outline; };
        if (std::none_of(parts.begin(), parts.end(), isArea)) {
            return run();
        }
        Domain domain;
        std::set<const SvgPath *, SameNodes> added;
        for (const bool areas : {true, false}) { // an outline rather than a line that is drawn along it
            for (std::size_t k = 0; k < paths_.size(); ++k) {
                const bool unused = parts[k] == PathRole::Nothing || parts[k] == PathRole::LeftOut;
                if (unused ? areas : isArea(parts[k]) != areas) {
                    continue;
                }
                roles_->noteReading(paths_[k], parts[k]);
                noteClips(paths_[k]);
                if (unused) {
                    continue;
                }
                if (!added.insert(&paths_[k]).second) {
                    noteRepeated(paths_[k]);
                    continue;
                }
                if (parts[k] == PathRole::Painted && std::exchange(painted_, paths_[k].element) != paths_[k].element &&
                    !domain.nodes.empty()) {
                    source_.note("svg-shapes", "filled shapes are kept apart: one inside another is a hole",
                                 paths_[k].offset);
                }
                addApart(paths_[k], areas, domain);
            }
        }
        domain.boundaryNames = tags_.names();
        domain.curveTolerance = source_.options.curveTolerance;
        return domain;
    }

  private:
    /// Orders paths; those with the same nodes are equal.
    struct SameNodes {
        bool operator()(const SvgPath *a, const SvgPath *b) const {
            return std::lexicographical_compare(a->nodes.begin(), a->nodes.end(), b->nodes.begin(), b->nodes.end(),
                                                comesBefore);
        }
    };

    /// Removes outlines that coincide with another outline, since by the even-odd rule each pair would cancel out, and
    /// unnamed filled shapes that coincide with another, since the time to arrange them grows with the square of their
    /// number.
    void dropRepeatedOutlines() {
        if (source_.options.strict) { // what cancels out is refused
            return;
        }
        const std::map<std::size_t, std::size_t> subpaths = subpathsOfElements(paths_);
        dropRepeated([&](const SvgPath &path) { return roles_->of(path) == PathRole::Outline; });
        dropRepeated([&](const SvgPath &path) {
            return !source_.options.shapeRegions && roles_->of(path) == PathRole::Painted && !path.paint.stroked &&
                   !path.removes && isGeneratedName(path.name) && subpaths.at(path.element) == 1;
        });
    }

    void dropRepeated(const std::function<bool(const SvgPath &)> &compares) {
        const std::vector<std::uint8_t> repeated = findRepeatedPaths(paths_, compares, kSameNode * size_);
        std::vector<SvgPath> kept;
        for (std::size_t k = 0; k < paths_.size(); ++k) {
            if (repeated[k] != 0) {
                noteRepeated(paths_[k]);
            } else {
                kept.push_back(std::move(paths_[k]));
            }
        }
        paths_ = std::move(kept);
    }

    void noteRepeated(const SvgPath &path) const {
        source_.note("svg-duplicate", "shapes that coincide with another shape are left out", path.offset);
    }

    /// Adds a path with nodes of its own.
    void addApart(const SvgPath &path, bool area, Domain &domain) {
        const bool closed = path.nodes.size() > 2 && (area || path.closed);
        const auto first = static_cast<std::uint32_t>(domain.nodes.size());
        const auto firstCurve = static_cast<std::uint32_t>(domain.curves.size());
        const std::int32_t tag = tags_.of(path.name);
        domain.curves.insert(domain.curves.end(), path.curves.begin(), path.curves.end());
        domain.nodes.push_back(path.nodes.front());
        for (std::size_t k = 0; k + (closed ? 0 : 1) < path.nodes.size(); ++k) {
            const bool back = k + 1 == path.nodes.size();
            const Vec2 to = back ? path.nodes.front() : path.nodes[k + 1];
            if (to == domain.nodes.back()) {
                continue;
            }
            const auto from = static_cast<std::uint32_t>(domain.nodes.size() - 1);
            CurveStretch stretch = k < path.stretches.size() ? path.stretches[k] : CurveStretch{};
            stretch.curve += stretch.follows() ? firstCurve : 0;
            if (!back) {
                domain.nodes.push_back(to);
            }
            domain.segments.push_back(
                {from, back ? first : from + 1, tag, area ? SegmentRole::Boundary : SegmentRole::Constraint, stretch});
        }
        if (domain.nodes.size() == first + 1) { // all of it in one place
            domain.nodes.pop_back();
        }
    }

    static constexpr auto kNone = static_cast<std::size_t>(-1);

    /// Adds the clips that limit something, with the indices that the paths refer to.
    void addClips() {
        std::vector<std::uint8_t> used(clips_.size(), 0);
        std::vector<std::uint32_t> open;
        const auto use = [&](std::uint32_t clip) {
            if (clip != kNoClip && std::exchange(used[clip], 1) == 0) {
                open.push_back(clip);
            }
        };
        std::for_each(paths_.begin(), paths_.end(), [&](const SvgPath &path) { use(path.limit); });
        while (!open.empty()) {
            const SvgClip &clip = clips_[open.back()];
            open.pop_back();
            use(clip.within);
            std::for_each(clip.parts.begin(), clip.parts.end(), [&](const SvgPath &part) { use(part.limit); });
        }
        for (const SvgClip &clip : clips_) {
            builder_.addClip(clip.within);
        }
        for (std::uint32_t clip = 0; clip < clips_.size(); ++clip) {
            if (used[clip] != 0) {
                addParts(clip);
            }
        }
    }

    void addParts(std::uint32_t clip) {
        std::size_t element = kNone;
        std::uint32_t contour = 0;
        for (SvgPath &part : clips_[clip].parts) {
            if (part.nodes.size() < 3) {
                continue;
            }
            builder_.from({part.offset});
            builder_.addCurves(part.curves, part.stretches);
            if (std::exchange(element, part.element) != part.element) {
                contour = builder_.addContour(builder_.addClipPart(clip, part.limit, part.removes), part.paint.rule);
            }
            const std::int32_t tag = tags_.of(part.name);
            clipTags_.insert(tag);
            builder_.addRing(contour, part.nodes, tag, part.stretches);
        }
    }

    /// Returns the contour of all outlines that a clip limits; they are one shape.
    std::uint32_t outlineContour(std::uint32_t feature, std::uint32_t limit) {
        const auto [known, added] = outlineContours_.try_emplace(limit, 0);
        if (added) {
            known->second = builder_.addContour(builder_.addShape(feature, {}, limit), FillRule::EvenOdd);
        }
        return known->second;
    }

    /// Returns the names of boundary parts, without those of clips that bound nothing.
    std::map<std::int32_t, std::string> usedNames(const Domain &domain) const {
        std::set<std::int32_t> unused = clipTags_;
        for (const SvgPath &path : paths_) {
            if (const auto tag = tags_.find(path.name)) {
                unused.erase(*tag);
            }
        }
        for (const DomainSegment &segment : domain.segments) {
            unused.erase(segment.tag);
        }
        std::map<std::int32_t, std::string> names = tags_.names();
        for (const std::int32_t tag : unused) {
            names.erase(tag);
        }
        return names;
    }

    /// Reports, for shapes that are kept apart, that clips do not limit them.
    void noteClips(const SvgPath &path) {
        for (std::uint32_t limit = path.limit; limit != kNoClip; limit = clips_[limit].within) {
            if (clips_[limit].kind == SvgClipKind::ClipPath) {
                source_.note("svg-clip-path", "clip paths are ignored: clipped shapes are imported in full",
                             path.offset);
            } else if (clips_[limit].kind != SvgClipKind::Viewport) {
                source_.note("svg-mask", "masks are ignored: masked shapes are imported in full", path.offset);
            }
        }
    }

    /// Returns the contents that options affect, whether or not they are set.
    DrawingContents contents(std::size_t whiteShapes) const {
        DrawingContents contents;
        contents.whiteShapes = whiteShapes;
        contents.whiteHoles = whiteShapes > 0 && makesHoles();
        std::size_t last = kNone;
        for (const SvgPath &path : paths_) {
            const PathRole part = roles_->of(path);
            contents.lines =
                contents.lines || (roles_->anyPainted() && (part == PathRole::Line || part == PathRole::LeftOut));
            if (path.covers() && std::exchange(last, path.element) != path.element) {
                ++contents.filledShapes;
            }
        }
        return contents;
    }

    /// Tells the builder whether shapes are regions and whether lines may bound the domain.
    void chooseRules() {
        if (!roles_->anyPainted()) {
            builder_.letLinesBound(tags_);
            if (source_.options.shapeRegions && !paths_.empty()) {
                source_.note("svg-regions", "nothing is filled: there are no shapes to make regions of",
                             paths_.front().offset);
            }
        } else if (source_.options.shapeRegions) {
            builder_.layer();
            builder_.markRegions();
        } else {
            roles_->noteMerged(paths_);
            strokes_.setBackground(noteBackground(source_, paths_, clips_));
        }
    }

    /// Returns true if white shapes that lie on others are holes in these.
    bool makesHoles() const { return source_.options.whiteHoles.value_or(true); }

    /// Reports white shapes that are merged with those below them, or that are holes without having been asked for.
    void noteWhite(const SvgWhiteShapes &white) const {
        const bool asked = source_.options.whiteHoles.value_or(false);
        for (std::size_t k = 0; k < paths_.size() && !asked; ++k) {
            if (white.contains(k) && (k == 0 || paths_[k - 1].element != paths_[k].element)) {
                source_.note(kWhiteNote,
                             makesHoles()
                                 ? "white shapes on others are holes; --no-white-holes merges them with these"
                                 : "white shapes on others are merged with them; --white-holes makes them holes",
                             paths_[k].offset);
            }
        }
    }

    /// Removes the area of a path from the shapes of the elements below it.
    void addHole(SvgPath &path, const std::vector<std::size_t> &below) {
        const std::int32_t tag = tags_.of(path.name);
        builder_.from({path.offset});
        builder_.addCurves(path.curves, path.stretches); // renumbers the stretches
        for (const std::size_t element : below) {
            const auto [known, added] = holeContours_.try_emplace({path.element, element}, 0);
            if (added) {
                known->second = builder_.addContour(shapes_.at(element), path.paint.rule, true);
            }
            builder_.addRing(known->second, path.nodes, tag, path.stretches);
        }
    }

    /// Returns the width of a stroke that may repeat an outline, which is limited for drawings in small units whose
    /// strokes have the default width of 1. Lines with a name of their own are kept.
    double widthOf(const SvgPath &path) const {
        return isGeneratedName(path.name) ? std::min(path.strokeWidth, kMaxStroke * size_) : 0.0;
    }

    /// Returns the shape of a path's element: its filled area and the painted area of its stroke. It belongs to the
    /// given feature, or to a new one.
    std::uint32_t shapeOf(std::uint32_t feature, const SvgPath &path) {
        if (std::exchange(shaped_, path.element) != path.element) {
            const bool apart = source_.options.shapeRegions;
            shape_ = builder_.addShape(apart ? builder_.addFeature(regions_.tagOf(path.name), path.name) : feature,
                                       path.name, path.limit);
        }
        return shape_;
    }

    void addLine(const SvgPath &path, std::int32_t tag) {
        std::vector<Vec2> nodes = path.nodes;
        if (path.closed && nodes.size() > 2) {
            nodes.push_back(nodes.front());
        }
        builder_.addChain(nodes, tag, path.stretches, path.limit, widthOf(path));
    }

    const SourceText &source_;
    std::vector<SvgPath> paths_;
    std::vector<SvgClip> clips_;
    DrawingBuilder builder_;
    StrokeAreas strokes_;
    TagAllocator tags_;
    std::optional<SvgRoles> roles_; ///< once ends are joined
    SvgRegions regions_;            ///< used if every filled shape is a region
    double size_;                   ///< diagonal of what is visible
    std::size_t shaped_ = kNone;    ///< the element of the last shape
    std::uint32_t shape_ = 0;
    std::size_t painted_ = kNone; ///< the element of the last contour
    std::uint32_t contour_ = 0;
    std::map<std::uint32_t, std::uint32_t> outlineContours_; ///< by the clip that limits the outlines
    std::map<std::size_t, std::uint32_t> shapes_;            ///< by painted element
    /// The contour of the holes of a white element in the shape of an element below it.
    std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> holeContours_;
    std::set<std::int32_t> clipTags_;
};

} // namespace

bool looksLikeSvg(std::string_view head) {
    constexpr std::string_view kRoot = "svg";
    for (std::size_t at = head.find(kRoot); at != std::string_view::npos; at = head.find(kRoot, at + 1)) {
        const std::size_t begin = head.substr(0, at).find_last_of("<>\"' \t\r\n");
        const bool opens = begin != std::string_view::npos && head[begin] == '<';
        if (opens && (begin + 1 == at || head[at - 1] == ':')) {
            return true; // <svg or <prefix:svg
        }
    }
    return false;
}

Result<Domain> readSvg(const SourceText &source) {
    Result<SvgPaths> drawing = drawnPaths(source);
    if (!drawing) {
        return drawing.faults();
    }
    if (source.options.whiteHoles || SvgWhiteShapes(drawing->paths).count() == 0) {
        return SvgBuilder(std::move(*drawing), source).run();
    }
    // White shapes are holes unless nothing remains, so this reading may count only if something does.
    ImportNotes notes = source.notes != nullptr ? *source.notes : ImportNotes();
    SourceText trial = source;
    trial.notes = source.notes != nullptr ? &notes : nullptr;
    if (Result<Domain> domain = SvgBuilder(*drawing, trial).run(); domain && !domain->segments.empty()) {
        if (source.notes != nullptr) {
            *source.notes = std::move(notes);
        }
        return domain;
    }
    SourceText merged = source;
    merged.options.whiteHoles = false;
    return SvgBuilder(std::move(*drawing), merged).run();
}

Result<Domain> readSvgShapes(const SourceText &source) {
    SourceText whole = source;
    whole.options.beyondPage = true;
    Result<SvgPaths> drawing = drawnPaths(whole);
    if (!drawing) {
        return drawing.faults();
    }
    return SvgBuilder(std::move(*drawing), source).runApart();
}

} // namespace forefront
