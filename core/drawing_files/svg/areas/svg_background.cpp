#include "core/drawing_files/svg/areas/svg_background.hpp"

#include "core/drawing_files/svg/drawing/svg_clip_boxes.hpp"
#include "core/engine/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>

namespace forefront {

namespace {

constexpr double kRounded = 0.01;   ///< part of the area of a rectangle that its corners may lack
constexpr double kUncovered = 0.01; ///< part of the size of a drawing that may lie beyond its background
constexpr double kAsWhite = 0.98;   ///< minimum luminance of what looks white

bool isRectangle(const SvgPath &path) {
    const Vec2 size = path.bounds().size();
    return path.nodes.size() > 3 && std::fabs(signedArea(path.nodes)) >= (1.0 - kRounded) * size.x * size.y;
}

class BackgroundFinder {
  public:
    BackgroundFinder(const std::vector<SvgPath> &paths, const std::vector<SvgClip> &clips)
        : paths_(paths), clips_(clips), boxes_(clips, true) {
        for (const SvgPath &path : paths) {
            const Box2 box = shown(path);
            if (box.empty()) {
                continue;
            }
            if (path.covers()) {
                filled_.add(box);
                ++subpaths_[path.element];
            } else if (path.paint.stroked) {
                lines_.add(box);
            }
        }
    }

    /// Returns the rectangle that covers all other filled shapes; null if there is none.
    const SvgPath *find() const {
        const auto found = std::find_if(paths_.begin(), paths_.end(), [&](const SvgPath &path) {
            const auto subpaths = subpaths_.find(path.element);
            return path.painted() && subpaths != subpaths_.end() && subpaths->second == 1 && isRectangle(path) &&
                   clippedToRectangle(path) && covers(path, filled_);
        });
        return found == paths_.end() ? nullptr : &*found;
    }

    std::size_t otherShapes() const { return subpaths_.size() - 1; }

    /// Returns true if there are lines, and all of them lie in a rectangle.
    bool coversLines(const SvgPath &rectangle) const { return !lines_.empty() && covers(rectangle, lines_); }

  private:
    Box2 shown(const SvgPath &path) const { return boxes_.visible(path.bounds().grown(path.reach()), path.limit); }

    bool covers(const SvgPath &rectangle, const Box2 &box) const {
        const Box2 area = shown(rectangle).grown(kUncovered * box.diagonal());
        return area.contains(box.min) && area.contains(box.max);
    }

    /// Returns true if all clips that limit a rectangle leave a rectangle of it.
    bool clippedToRectangle(const SvgPath &path) const {
        for (std::uint32_t limit = path.limit; limit != kNoClip; limit = clips_[limit].within) {
            const std::vector<SvgPath> &parts = clips_[limit].parts;
            if (parts.size() != 1 || parts.front().removes || parts.front().limit != kNoClip ||
                !isRectangle(parts.front())) {
                return false;
            }
        }
        return true;
    }

    const std::vector<SvgPath> &paths_;
    const std::vector<SvgClip> &clips_;
    SvgClipBoxes boxes_;
    Box2 filled_, lines_;                         ///< of what is shown
    std::map<std::size_t, std::size_t> subpaths_; ///< numbers of those of filled elements
};

/// Returns true if other filled shapes are drawn over one, so that they remain if each is a region.
bool isDrawnOver(const SvgPath &shape, const std::vector<SvgPath> &paths) {
    return std::any_of(paths.begin(), paths.end(),
                       [&](const SvgPath &path) { return path.covers() && path.element > shape.element; });
}

} // namespace

Box2 noteBackground(const SourceText &source, const std::vector<SvgPath> &paths, const std::vector<SvgClip> &clips) {
    const BackgroundFinder finder(paths, clips);
    const SvgPath *const rectangle = finder.find();
    if (rectangle == nullptr) {
        return {};
    }
    const std::size_t others = finder.otherShapes();
    if (others > 0) {
        source.note("svg-background",
                    "a filled rectangle covers the " +
                        (others == 1 ? "other filled shape, which vanishes"
                                     : std::to_string(others) + " other filled shapes, which vanish") +
                        " in it; remove it if it is a background" +
                        (isDrawnOver(*rectangle, paths) ? "; --shape-regions makes each shape a region" : ""),
                    rectangle->offset);
    } else if (rectangle->paint.fill.plain && rectangle->paint.fill.luminance >= kAsWhite &&
               finder.coversLines(*rectangle)) {
        source.note("svg-background",
                    "a white rectangle is the only filled shape, and everything else is lines in it; remove it if it "
                    "is a background",
                    rectangle->offset);
    }
    const Box2 box = rectangle->bounds();
    return rectangle->limit == kNoClip ? box.grown(-2.0 * kUncovered * box.diagonal()) : Box2();
}

} // namespace forefront
