#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/periodic_sides.hpp"
#include "core/engine/domain/segment_elements.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

/// What the boundary of a job is discretised with, beside the spacing. Refers to its parts.
struct BoundaryDivision {
    const MeshingJob &job;    ///< its options and its spacing
    const Domain &domain;     ///< that of the job, or one with the same segments
    SegmentElements elements; ///< numbers of elements along lines and curves
    const DomainFaces &faces;
    const PeriodicSides &periodic;
};

/// Discretises the boundary, estimates the number of elements and checks it against `limit`. Around periodic parts that
/// are finer than `spacing`, for the sake of the other part, the spacing of the result is lower. Errors: those of
/// discretise(), "too-many-elements".
Result<PreparedJob> discretised(const BoundaryDivision &division, std::shared_ptr<const SpacingField> spacing,
                                std::uint64_t limit, const Progress &progress);

} // namespace forefront
