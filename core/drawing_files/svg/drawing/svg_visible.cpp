#include "core/drawing_files/svg/drawing/svg_clip_boxes.hpp"
#include "core/drawing_files/svg/drawing/svg_crop.hpp"
#include "core/drawing_files/svg/drawing/svg_drawer.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace forefront {

namespace {

constexpr double kBeyond = 1e-3; ///< part of a viewport by which rounding may exceed it

/// Returns true if the unit square under a map contains a path, up to rounding.
bool contains(const AffineMap &frame, const SvgPath &path) {
    const std::optional<AffineMap> back = frame.inverse();
    if (!back) {
        return false;
    }
    const Box2 square = Box2{{0.0, 0.0}, {1.0, 1.0}}.grown(kBeyond);
    const auto inside = [&](Vec2 p) { return square.contains((*back)(p)); };
    const auto holds = [&](const Box2 &box) {
        return inside(box.min) && inside(box.max) && inside({box.min.x, box.max.y}) && inside({box.max.x, box.min.y});
    };
    const auto follows = [&](const CurveStretch &stretch) {
        return !stretch.follows() || holds(path.curves[stretch.curve].bounds(stretch.t0, stretch.t1));
    };
    if (path.strokeArea) {
        return holds(path.bounds().grown(path.farthestReach()));
    }
    return std::all_of(path.nodes.begin(), path.nodes.end(), inside) &&
           std::all_of(path.stretches.begin(), path.stretches.end(), follows);
}

/// Returns the box of the unit square under a map.
Box2 imageBox(const AffineMap &frame) {
    Box2 box;
    for (const Vec2 corner : {Vec2{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        box.add(frame(corner));
    }
    return box;
}

bool hasArea(const Box2 &box) {
    return box.min.x < box.max.x && box.min.y < box.max.y;
}

} // namespace

/// Cuts nothing off at the page if nothing is filled, as in a drawing of outlines, or if all that is filled lies
/// outside of it.
void SvgDrawer::choosePage() {
    if (!page_) {
        return;
    }
    const SvgClipBoxes boxes(clips_, false);
    const Box2 page = imageBox(*page_);
    bool painted = false, shown = false;
    for (const SvgPath &path : paths_) {
        const Box2 visible = boxes.visible(path.box().grown(path.reach()), path.limit);
        painted = painted || (path.covers() && hasArea(visible));
        shown = shown || (path.covers() && hasArea(commonBox(visible, page)));
    }
    if (!shown) {
        page_.reset();
    }
    if (painted && !shown) {
        note(root_, "svg-off-page", "all filled shapes lie outside the page (the view box): they are read in full");
    }
}

/// Reports that shapes are cut off at the page.
void SvgDrawer::notePage() const {
    const SvgClipBoxes boxes(clips_, false);
    Box2 page = imageBox(*page_);
    page = page.grown(kBeyond * std::min(page.size().x, page.size().y));
    for (const SvgPath &path : paths_) {
        const Box2 visible = boxes.visible(path.bounds().grown(path.reach()), path.limit);
        if (!visible.empty() && !(page.contains(visible.min) && page.contains(visible.max))) {
            note(root_, kPageNote, "shapes are cut off at the page (the view box), as renderers show them");
            return;
        }
    }
}

/// Crops shapes and clips that reach far beyond the page to its surroundings; the page then cuts off the rest exactly.
/// Others are left as they are: many that run along the same sides would overlap there.
void SvgDrawer::cropFarFromPage(double tolerance) {
    constexpr double kFarPages = 16.0;
    const Box2 page = imageBox(*page_), around = page.grown(page.diagonal());
    const Box2 far = page.grown(kFarPages * page.diagonal());
    const auto reachesFar = [&](const SvgPath &path) {
        const Box2 bounds = path.bounds();
        return path.nodes.size() > 1 && !(far.contains(bounds.min) && far.contains(bounds.max));
    };
    std::vector<SvgPath> kept;
    for (SvgPath &path : paths_) {
        if (path.strokeArea || !reachesFar(path)) { // a cropped stroke would have other ends and dashes
            kept.push_back(std::move(path));
            continue;
        }
        cropsFill_ = cropsFill_ || path.painted();
        const bool area = path.painted() || (path.closed && !path.paint.stroked);
        std::vector<SvgPath> lines;
        if (!area || (path.paint.stroked && !path.closed)) {
            lines = croppedLines(path, around, tolerance);
        }
        if (area) {
            cropArea(path, around, tolerance);
            kept.push_back(std::move(path));
        }
        std::move(lines.begin(), lines.end(), std::back_inserter(kept));
    }
    paths_ = std::move(kept);
    for (SvgClip &clip : clips_) {
        for (SvgPath &part : clip.parts) {
            if (part.nodes.size() > 2 && reachesFar(part)) { // others clip everything
                cropArea(part, around, tolerance);
            }
        }
    }
}

/// Returns the box of the shapes, as far as the page and the boxes of clip paths and masks show them.
Box2 SvgDrawer::visibleBox() const {
    const SvgClipBoxes boxes(clips_, false);
    const Box2 page = page_ ? imageBox(*page_) : kEverything;
    Box2 box;
    for (const SvgPath &path : paths_) {
        const Box2 visible = commonBox(boxes.visible(path.box().grown(path.reach()), path.limit), page);
        if (!visible.empty()) {
            box.add(visible);
        }
    }
    return box;
}

/// Removes viewports that cut nothing off, which nearly all are.
void SvgDrawer::dropWideViewports() {
    const auto isViewport = [](const SvgClip &clip) { return clip.kind == SvgClipKind::Viewport; };
    if (std::none_of(clips_.begin(), clips_.end(), isViewport)) {
        return;
    }
    std::vector<std::uint8_t> needed(clips_.size(), 0);
    const auto look = [&](const SvgPath &path, std::uint32_t limit) {
        for (; limit != kNoClip; limit = clips_[limit].within) {
            if (isViewport(clips_[limit]) && needed[limit] == 0 && !contains(clips_[limit].frame, path)) {
                needed[limit] = 1;
            }
        }
    };
    const auto relink = [&](std::uint32_t &limit) {
        while (limit != kNoClip && isViewport(clips_[limit]) && needed[limit] == 0) {
            limit = clips_[limit].within;
        }
    };
    const auto forEachPath = [&](const auto &visit) {
        std::for_each(paths_.begin(), paths_.end(), [&](SvgPath &path) { visit(path); });
        for (SvgClip &clip : clips_) {
            std::for_each(clip.parts.begin(), clip.parts.end(), [&](SvgPath &path) { visit(path); });
        }
    };
    std::for_each(paths_.begin(), paths_.end(), [&](const SvgPath &path) { look(path, path.limit); });
    for (const SvgClip &clip : clips_) {
        for (const SvgPath &part : clip.parts) {
            look(part, part.limit);
        }
    }
    forEachPath([&](SvgPath &path) { relink(path.limit); });
    std::for_each(clips_.begin(), clips_.end(), [&](SvgClip &clip) { relink(clip.within); });
}

} // namespace forefront
