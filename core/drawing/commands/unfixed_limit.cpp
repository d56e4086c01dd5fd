#include "core/drawing/commands/unfixed_limit.hpp"

namespace forefront {

std::string whyNoFix(MeshLimit limit, bool layered) {
    switch (limit) {
    case MeshLimit::MinIslandArea:
        return "islands belong to the outline: remove the small ones from the drawing";
    case MeshLimit::MaxLayerAspect:
        return "the heights of boundary layers are given: make the first one higher";
    case MeshLimit::MaxAspect:
        if (layered) {
            return "the heights of boundary layers are given: make the first one higher, or limit their aspect ratio "
                   "apart from that of the other elements";
        }
        break;
    case MeshLimit::MinAngle:
    case MeshLimit::MaxAngle:
        return "a corner, or a segment that may not be divided, forces this: change the outline there, or the limit";
    default:
        break;
    }
    return "the outline forces this: change the outline there, or the limit";
}

} // namespace forefront
