#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/length_unit.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/mapped_spec.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/layers/layer_spec.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/engine/strips/strip_spec.hpp"

#include <cstdint>
#include <vector>

namespace FOREFRONT_API forefront {

/// A domain read from a file: its geometry, and the element sizes that come with it, such as the maximum areas of the
/// regions of a .poly file or the spacing of a project. Mesh it with both: MeshingJob{file.domain, file.spacing, {}}.
struct DomainFile {
    Domain domain;
    SpacingSpec spacing;
    LengthUnit unit = LengthUnit::None;           ///< of the coordinates, if the file names one
    std::vector<std::int32_t> cracks{};           ///< tags of inner lines that are cracks; see MeshingJob::cracks
    std::vector<PeriodicSpec> periodic{};         ///< parts that are divided alike; see MeshingJob::periodic
    std::vector<MappedSpec> mapped{};             ///< regions filled by rows of elements; see MeshingJob::mapped
    std::vector<StripSpec> strips{};              ///< inner lines with a width; see MeshingJob::strips
    std::vector<LayerSpec> layers{};              ///< boundary layers; see MeshingJob::layers
    std::vector<RegionElements> regionElements{}; ///< see MeshingJob::regionElements
};

} // namespace forefront
