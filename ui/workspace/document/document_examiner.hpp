#pragma once

#include "core/drawing/constraints/sketch_state.hpp"
#include "core/drawing/domain/shared_domain.hpp"
#include "core/drawing/picking/face_map.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/mapped/mapped_faces.hpp"
#include "core/engine/spacing/shared_spacing.hpp"
#include "ui/background/latest.hpp"
#include "ui/workspace/document/layer_planner.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <stop_token>
#include <vector>

namespace forefront {

struct Document;

/// The domain, faults and spacing of a document before it is meshed. Computed on a separate thread, so that drawing and
/// painting never wait for it.
struct DocumentPreview {
    std::uint64_t revision = 0;
    std::shared_ptr<const Domain> domain;
    std::shared_ptr<const SpacingField> spacing; ///< null if it cannot be built
    Diagnostics faults;                          ///< in the domain and the spacing
    std::shared_ptr<const FaceMap> faces;        ///< of the domain; null: none, or it has too many segments
    std::shared_ptr<const SketchState> sketch;   ///< null: the document has no constraints
    std::map<std::int32_t, std::vector<MappedOutline>> mapped; ///< faces to be filled by rows, by region
    double estimatedElements = 0.0;                            ///< see estimateElements(); 0: unknown
    double largestSpacing = 0.0;                               ///< found in the faces of the domain; 0: unknown
};

/// ρ sampled at the cell centres of a lattice over a box, row by row from the bottom; 0 outside the field.
struct SpacingRaster {
    std::uint64_t revision = 0;
    Box2 box;
    int columns = 0, rows = 0;
    std::vector<float> rho;
};

/// Computes the preview of a document, and a raster of its spacing, on a separate thread. Call all members from one
/// thread; none of them waits, except the destructor.
class DocumentExaminer {
  public:
    explicit DocumentExaminer(BackgroundList &list);

    /// Sets the document to examine, with its domain; cheap if the revision has not changed. Work on an earlier
    /// revision is finished and shown first, so that the preview keeps moving when edits come faster than it can be
    /// computed. `spacing`: where others need the field of this document, too.
    void submit(std::shared_ptr<SharedDomain> drawn, std::uint64_t revision, std::shared_ptr<SharedSpacing> spacing);
    /// Sets the raster of ρ to compute; cheap when unchanged. With 0 columns, no raster is computed.
    void submitRaster(const Box2 &box, int columns, int rows);
    /// Stops the current work and drops its results, because another document has been opened.
    void abandon();
    /// Fetches the newest preview and raster. Returns true if one of them is new.
    bool refresh() { return worker_.refresh(); }
    /// Returns the preview and the raster fetched last; never null.
    const std::shared_ptr<const DocumentPreview> &preview() const { return worker_.now().preview; }
    const std::shared_ptr<const SpacingRaster> &raster() const { return worker_.now().raster; }
    /// Plans the boundary layers of the document, apart from its preview.
    LayerPlanner &layers() { return layers_; }
    const LayerPlanner &layers() const { return layers_; }

  private:
    struct RasterRequest {
        Box2 box;
        int columns = 0, rows = 0;
        std::uint64_t number = 0;
    };
    struct Request {
        std::shared_ptr<SharedDomain> drawn; ///< null: no document yet
        std::shared_ptr<SharedSpacing> spacing;
        std::uint64_t revision = 0;
        RasterRequest raster;
    };
    struct Answer {
        std::shared_ptr<const DocumentPreview> preview = std::make_shared<DocumentPreview>();
        std::shared_ptr<const SpacingRaster> raster = std::make_shared<SpacingRaster>();
        std::uint64_t rasterNumber = 0;
    };
    static Answer answer(const LatestTurn<Request, Answer> &turn);
    static std::shared_ptr<const DocumentPreview> examine(const Request &request, const std::stop_token &stop);

    Request wanted_;
    Latest<Request, Answer> worker_;
    LayerPlanner layers_;
};

} // namespace forefront
