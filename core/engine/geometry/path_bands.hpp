#pragma once

#include "core/engine/geometry/curve.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace forefront {

/// How the bands of consecutive segments are joined on the outside of a corner.
enum class BandCorner : std::uint8_t {
    Round,
    Bevel,
    Miter ///< up to a limit; a bevel beyond it
};

struct BandStyle {
    BandCorner corner = BandCorner::Round;
    double miterLimit = 4.0; ///< maximum length of a miter, in widths of the band
    double accuracy = 1e-7;  ///< of parallels that are not exact, as a fraction of the size of the result
    /// True: the band is the area swept by a line across the path. False: on the inside of a bend it ends at the
    /// centres of curvature, since points beyond them are nearer to other parts of the path.
    bool swept = false;
};

/// A part of a band: a closed outline.
struct BandPart {
    std::vector<Vec2> nodes;
    std::vector<Curve> curves; ///< from each node to the next; a line means straight, and its ends are ignored
    std::uint32_t segment = 0; ///< of the path: index
};

/// Returns shapes whose union is the band between a path and its parallels at one or two offsets, positive to the left
/// and negative to the right; one on either side gives the whole band. Parallels of lines and arcs of circles are
/// exact, parallels of other curves are cubics. The ends of an open path are cut straight.
std::vector<BandPart> bandsBeside(std::span<const Curve> path, bool closed, std::span<const double> offsets,
                                  const BandStyle &style = {});

/// Returns the half disc with the radius `arm` beyond the end of a path, where `arm` points to the left of the path and
/// `forward` is false at its start.
BandPart roundEnd(Vec2 end, Vec2 arm, bool forward);

} // namespace forefront
