#include "core/drawing/arrangement/cover/winding_walk.hpp"

#include <algorithm>

namespace forefront {

WindingWalk::WindingWalk(const ArrangementInput &input)
    : input_(input), winding_(input.contours.size(), 0), outer_(input.shapes.size(), 0), hole_(input.shapes.size(), 0),
      ofFeature_(input.features.size(), 0), place_(input.features.size(), 0), isListed_(input.features.size(), 0),
      clips_(input.clips.size()) {
    if (!clips_.empty()) {
        shapePlace_.resize(input.shapes.size());
        clipPlace_.resize(input.clips.size());
    }
}

void WindingWalk::add(std::uint32_t contour, std::int32_t change) {
    const bool before = insideContour(contour);
    winding_[contour] += change;
    const bool after = insideContour(contour);
    if (before == after) {
        return;
    }
    const ArrangementContour &about = input_.contours[contour];
    const bool inside = insideShape(about.shape);
    std::uint32_t &count = about.hole ? hole_[about.shape] : outer_[about.shape];
    after ? ++count : --count;
    if (inside != insideShape(about.shape)) {
        setInside(about.shape, !inside);
    }
}

std::vector<std::uint32_t> WindingWalk::takeSwitched() {
    for (const std::uint32_t feature : switched_) {
        isListed_[feature] = 0;
    }
    return std::exchange(switched_, {});
}

std::vector<std::uint32_t> WindingWalk::takeWatched() {
    watches_ = false;
    std::sort(watched_.begin(), watched_.end());
    std::vector<std::uint32_t> changed;
    for (auto first = watched_.begin(); first != watched_.end();) {
        const auto last = std::upper_bound(first, watched_.end(), *first);
        if ((last - first) % 2 != 0) { // otherwise it came back
            changed.push_back(*first);
        }
        first = last;
    }
    watched_.clear();
    return changed;
}

bool WindingWalk::insideContour(std::uint32_t contour) const {
    const std::int32_t winding = winding_[contour];
    return input_.contours[contour].rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
}

/// Notes that the place is now inside a shape or outside of it, whether or not its clip shows that.
void WindingWalk::setInside(std::uint32_t shape, bool inside) {
    const std::uint32_t limit = input_.shapes[shape].limit;
    if (limit != kNoClip) {
        IndexBag &around = clips_[limit].shapes;
        inside ? around.add(shape, shapePlace_) : around.remove(shape, shapePlace_);
    }
    if (shows(limit)) {
        setCovered(shape, inside);
        settle();
    }
}

void WindingWalk::setCovered(std::uint32_t shape, bool covered) {
    if (input_.shapes[shape].partOf != kNoClip) {
        setPart(shape, covered);
        return;
    }
    if (watches_) {
        watched_.push_back(shape);
    }
    const std::uint32_t feature = input_.shapes[shape].feature;
    if (covered) {
        ++shapes_;
        if (ofFeature_[feature]++ == 0) {
            features_.add(feature, place_);
            listSwitched(feature);
        }
    } else {
        --shapes_;
        if (--ofFeature_[feature] == 0) {
            features_.remove(feature, place_);
            listSwitched(feature);
        }
    }
}

/// Notes that a part of a clip starts or ceases to cover the place.
void WindingWalk::setPart(std::uint32_t shape, bool covered) {
    const std::uint32_t index = input_.shapes[shape].partOf;
    Clip &clip = clips_[index];
    if (covered) {
        clip.parts.insert(shape);
    } else {
        clip.parts.erase(shape);
    }
    const bool inside = !clip.parts.empty() && !input_.shapes[*clip.parts.rbegin()].removes;
    if (inside == clip.inside) {
        return;
    }
    clip.inside = inside;
    if (const std::uint32_t within = input_.clips[index].within; within != kNoClip) {
        IndexBag &around = clips_[within].clips;
        inside ? around.add(index, clipPlace_) : around.remove(index, clipPlace_);
    }
    unsettled_.push_back(index);
}

/// Opens and closes clips until all of them fit their parts and the clips around them. A list instead of recursion,
/// since a file can nest clips deeper than the stack.
void WindingWalk::settle() {
    while (!unsettled_.empty()) {
        const std::uint32_t index = unsettled_.back();
        unsettled_.pop_back();
        Clip &clip = clips_[index];
        const bool open = clip.inside && shows(input_.clips[index].within);
        if (open == clip.open) {
            continue;
        }
        clip.open = open;
        for (const std::uint32_t shape : clip.shapes.list()) {
            setCovered(shape, open);
        }
        unsettled_.insert(unsettled_.end(), clip.clips.list().begin(), clip.clips.list().end());
    }
}

void WindingWalk::listSwitched(std::uint32_t feature) {
    if (isListed_[feature] == 0) {
        isListed_[feature] = 1;
        switched_.push_back(feature);
    }
}

} // namespace forefront
