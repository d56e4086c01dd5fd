#pragma once

#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/strips/strip_spec.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace forefront {

/// A part of the line of a strip whose sides are one line or curve each.
struct SideRun {
    Curve curve;                ///< in the direction of the line; a line for a straight part
    std::uint32_t chords = 1;   ///< number of segments that its sides get
    std::uint32_t elements = 0; ///< number of elements along it; 0: as the spacing asks
    ElementBias bias{};         ///< of these, in the direction of the line
    bool straight() const { return curve.kind() == CurveKind::Line; }
    Vec2 start() const { return curve.point(0.0); }
    Vec2 end() const { return curve.point(1.0); }
};

/// One connected line of a strip.
struct StripLine {
    bool closed = false;
    std::uint32_t first = 0, last = 0;   ///< its end nodes in the domain
    std::vector<std::uint32_t> segments; ///< of the domain, in order
    std::vector<SideRun> runs;
};

/// Returns the lines of a strip, with curves divided so that their parallels at half the width are one curve each.
/// `elements`: of the domain. Errors, with the place: strip-meets (the line branches, or another line or a point meets
/// it between its ends), strip-bend (a curve bends more sharply than the width allows), strip-elements (a curve with a
/// number of elements has to be divided).
Result<std::vector<StripLine>> stripLines(const Domain &domain, const StripSpec &spec, const SegmentElements &elements);

/// Returns the parallel of a curve at a distance to its left (negative: to its right), with the same direction: exact
/// for lines and arcs of circles, else a cubic with the exact ends and derivatives. Nothing if the curve bends so
/// sharply that there is none.
std::optional<Curve> parallelTo(const Curve &curve, double offset);

/// Returns an error of a strip with its place.
Diagnostics stripError(const char *code, const Domain &domain, std::int32_t tag, const std::string &what,
                       const char *advice, Vec2 at);

} // namespace forefront
