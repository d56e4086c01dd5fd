#pragma once

#include "core/engine/base/api.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/base/enum_words.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/mapped_spec.hpp"
#include "core/engine/domain/periodic.hpp"
#include "core/engine/grid/grid_kind.hpp"
#include "core/engine/improve/improve_level.hpp"
#include "core/engine/layers/layer_spec.hpp"
#include "core/engine/mesh/second_order.hpp"
#include "core/engine/mesher/front_rules.hpp"
#include "core/engine/spacing/spec/spacing_spec.hpp"
#include "core/engine/strips/strip_spec.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace FOREFRONT_API forefront {

class SharedSpacing;

/// The method that advances the front.
enum class Method : std::uint8_t {
    Fast,   ///< walks along the front; a new node makes up to three elements
    Classic ///< Lo's ten steps: shortest segment first, of equal ones the oldest, one element per advance
};

template <>
struct EnumWords<Method> {
    static constexpr auto kLast = Method::Classic;
    static constexpr std::array<std::string_view, 2> kList = {"fast", "classic"};
};

/// The shapes of the elements of a mesh.
enum class Elements : std::uint8_t {
    Triangles,
    Quads, ///< quadrilaterals; triangles only where a face has an odd number of edges that must stay
    Mixed  ///< quadrilaterals where they are well shaped, else triangles
};

template <>
struct EnumWords<Elements> {
    static constexpr auto kLast = Elements::Mixed;
    static constexpr std::array<std::string_view, 3> kList = {"triangles", "quads", "mixed"};
};

/// The shapes of the elements of one region, where they differ from those of the other regions.
struct RegionElements {
    std::int32_t region = 1; ///< tag
    Elements elements = Elements::Triangles;

    friend bool operator==(const RegionElements &, const RegionElements &) = default;
};

/// Maximum number of elements: half-edges, three per element, have ids of 31 bits.
inline constexpr std::uint64_t kMaxElements = 700'000'000;
/// Default of MeshingOptions::maxElements, which take about 8 GB while they are made.
inline constexpr std::uint64_t kDefaultMaxElements = 50'000'000;

/// Options for meshing a domain.
struct MeshingOptions {
    /// Quadrilaterals are made by a front of their own on one thread, whatever the method and the number of threads.
    Elements elements = Elements::Triangles;
    /// Of second order, nodes in the middles of edges lie on the curves of the domain; see raiseOrder().
    ElementOrder order = ElementOrder::First;
    QuadNodes quadNodes = QuadNodes::Eight; ///< of quadrilaterals of second order
    Method method = Method::Fast;
    GridKind grid = GridKind::Hierarchical;
    int gridColumns = 0; ///< uniform grid only; 0: automatic
    int gridRows = 0;
    /// No angle of a triangle may be smaller, degrees, except where the domain forces it; see refineToLeastAngle().
    std::optional<double> leastAngle{};
    bool keepBoundary = false; ///< the given segments become edges of the mesh and are not subdivided
    /// Improvement once the front is closed. The fast method advances more carefully at higher levels, see FrontCare.
    ImproveLevel improve = ImproveLevel::Default;
    unsigned threads = 1; ///< the mesh does not depend on it; see also SpacingSpec::functionThreadSafe
    /// A job that needs more elements is refused: by an estimate before the front starts or, where that was too low,
    /// when the front exceeds it by a quarter. At most kMaxElements.
    std::uint64_t maxElements = kDefaultMaxElements;

    /// Check the finished mesh against its domain, as verifyAgainst() does. Faults end the run.
    bool verify = false;

    FrontRules rules{}; ///< of the classic method

    friend bool operator==(const MeshingOptions &, const MeshingOptions &) = default;
};

/// Returns true if a run with these options makes quadrilaterals, by the two-coloured front.
inline bool makesQuads(const MeshingOptions &options) {
    return options.elements != Elements::Triangles;
}

/// The complete input of a meshing run.
///
/// Exceptions: functions that take a job throw what its size function and their Progress throw, and nothing else; they
/// free what they hold. Only std::bad_alloc becomes the error "out-of-memory" where that is listed.
struct MeshingJob {
    Domain domain;
    SpacingSpec spacing;
    MeshingOptions options;
    std::shared_ptr<SharedSpacing> shared{}; ///< where others need the field of this job, too; null: nobody does
    std::vector<LayerSpec> layers{};         ///< boundary layers, at most one specification for each boundary tag
    std::vector<PeriodicSpec> periodic{};    ///< parts that are divided alike; each part belongs to one pair at most
    std::vector<std::int32_t> cracks{};      ///< tags of inner lines that are cracks; see openCracks()
    std::vector<MappedSpec> mapped{};        ///< faces filled by rows of elements
    std::vector<StripSpec> strips{};         ///< inner lines with a width, at most one specification for each
    /// Regions with other elements than MeshingOptions::elements, each once.
    std::vector<RegionElements> regionElements{};
    /// What the maker of the job found, for the user: an error refuses the job, other findings change nothing.
    Diagnostics findings{};

    /// Returns the number of threads that may work on this job: one if its size function must not be called from
    /// others.
    unsigned usableThreads() const {
        return spacing.hasFunction() && !spacing.functionThreadSafe ? 1U : options.threads;
    }
};

} // namespace forefront
