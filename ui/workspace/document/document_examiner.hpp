#pragma once

#include "core/drawing/domain/shared_domain.hpp"
#include "core/drawing/picking/face_map.hpp"
#include "core/engine/base/diagnostic.hpp"
#include "core/engine/domain/domain.hpp"
#include "core/engine/spacing/shared_spacing.hpp"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
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
    double estimatedElements = 0.0;              ///< see estimateElements(); 0: unknown
    double largestSpacing = 0.0;                 ///< found in the faces of the domain; 0: unknown
};

/// ρ sampled at the cell centres of a lattice over a box, row by row from the bottom; 0 outside the field.
struct SpacingRaster {
    std::uint64_t revision = 0;
    Box2 box;
    int columns = 0, rows = 0;
    std::vector<float> rho;
};

/// Computes the preview of a document, and a raster of its spacing, on a separate thread.
class DocumentExaminer {
  public:
    /// `wake` is called from that thread when a result is ready.
    explicit DocumentExaminer(std::function<void()> wake);
    ~DocumentExaminer();
    DocumentExaminer(const DocumentExaminer &) = delete;
    DocumentExaminer &operator=(const DocumentExaminer &) = delete;

    /// Sets the document to examine, with its domain; cheap if the revision has not changed. Work on an earlier
    /// revision is finished and shown first, so that the preview keeps moving when edits come faster than it can be
    /// computed. `spacing`: where others need the field of this document, too.
    void submit(std::shared_ptr<SharedDomain> drawn, std::uint64_t revision, std::shared_ptr<SharedSpacing> spacing);
    /// Sets the raster of ρ to compute; cheap when unchanged. With 0 columns, no raster is computed.
    void submitRaster(const Box2 &box, int columns, int rows);
    /// Stops the current work, because another document is about to be opened.
    void abandon();
    /// Returns the newest preview and the newest raster; never null.
    std::shared_ptr<const DocumentPreview> latest() const;
    std::shared_ptr<const SpacingRaster> raster() const;
    /// Returns true while any submitted work is unfinished.
    bool busy() const;

  private:
    struct RasterRequest {
        Box2 box;
        int columns = 0, rows = 0;
        std::uint64_t number = 0;
    };
    void work(const std::stop_token &stop);
    static std::shared_ptr<const DocumentPreview> examine(SharedDomain &drawn, std::uint64_t revision,
                                                          SharedSpacing &spacing, const std::stop_token &stop);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::shared_ptr<SharedDomain> wanted_;
    std::shared_ptr<SharedSpacing> wantedSpacing_;
    std::uint64_t wantedRevision_ = 0;
    RasterRequest wantedRaster_;
    std::uint64_t doneRevision_ = 0, rasterNumber_ = 0, rasterRevision_ = 0;
    std::shared_ptr<const DocumentPreview> preview_;
    std::shared_ptr<const SpacingRaster> raster_;
    std::stop_source examining_;
    std::jthread thread_;
};

} // namespace forefront
