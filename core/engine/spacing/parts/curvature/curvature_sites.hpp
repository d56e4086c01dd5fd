#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/domain/curve_chains.hpp"
#include "core/engine/domain/lazy_faces.hpp"
#include "core/engine/spacing/sites/site_set.hpp"

namespace forefront {

/// Edges per full turn of a curved boundary where the spacing is automatic: the polygon of a circle then covers 99.6 %
/// of its area.
inline constexpr double kSegmentsPerTurn = 40.0;

/// Adds the sites of the curvature rule: a spacing of 2π / (n κ) along curves of curvature κ, where n is
/// `segmentsPerTurn`, growing by `gradation`. Curves with a number of `elements` are left out.
///
/// With `visibleOnly`, where that would be needlessly fine, the spacing is such that edges leave at most a small
/// fraction of the diagonal between them and the curve, and all curves together at most a small part of the area. Bends
/// that this makes invisible, such as a barely rounded corner, count as corners. Incomplete after a stop request.
void addCurvatureSites(const Domain &domain, const LazyFaces &faces, const CurveChains &chains,
                       SegmentElements elements, double segmentsPerTurn, double minimum, double gradation,
                       SpacingOrigin origin, bool visibleOnly, const Progress &progress, SiteSet &sites);

} // namespace forefront
