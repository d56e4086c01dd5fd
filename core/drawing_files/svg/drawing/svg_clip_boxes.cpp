#include "core/drawing_files/svg/drawing/svg_clip_boxes.hpp"

#include <algorithm>

namespace forefront {

Box2 commonBox(const Box2 &s, const Box2 &t) {
    return {{std::max(s.min.x, t.min.x), std::max(s.min.y, t.min.y)},
            {std::min(s.max.x, t.max.x), std::min(s.max.y, t.max.y)}};
}

SvgClipBoxes::SvgClipBoxes(const std::vector<SvgClip> &clips, bool viewports) {
    for (const SvgClip &clip : clips) {
        if (!viewports && clip.kind == SvgClipKind::Viewport) {
            boxes_.push_back(visible(kEverything, clip.within));
            continue;
        }
        Box2 parts;
        for (const SvgPath &part : clip.parts) {
            parts.add(part.box());
        }
        boxes_.push_back(visible(parts, clip.within));
    }
}

Box2 SvgClipBoxes::visible(const Box2 &box, std::uint32_t clip) const {
    return clip == kNoClip ? box : commonBox(box, boxes_[clip]);
}

} // namespace forefront
