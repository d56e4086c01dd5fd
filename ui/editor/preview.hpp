#pragma once

#include "core/base/diagnostic.hpp"
#include "core/domain/domain.hpp"
#include "core/spacing/spacing_field.hpp"

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

/// What is known of the current document before it is meshed: its domain, the faults in it, its ρ. Worked out on a
/// thread of its own, so that neither drawing nor painting ever waits; results appear a moment later.
struct DocumentPreview {
    std::uint64_t revision = 0;
    std::shared_ptr<const Domain> domain;
    std::shared_ptr<const SpacingField> spacing; ///< null where it cannot be built
    Diagnostics faults;                          ///< of the domain and of the spacing
    double estimatedElements = 0.0;              ///< ∫ 4/(√3 ρ²) over the domain
};

/// ρ sampled on a lattice of pixel centres over a box, row by row from the bottom; 0 outside of the field.
struct SpacingRaster {
    std::uint64_t revision = 0;
    Box2 box;
    int columns = 0, rows = 0;
    std::vector<float> rho;
};

class Preview {
  public:
    explicit Preview(std::function<void()> wake);
    ~Preview();
    Preview(const Preview &) = delete;
    Preview &operator=(const Preview &) = delete;

    /// The document that shall be looked at; cheap when the revision is known.
    void submit(std::shared_ptr<const Document> document, std::uint64_t revision);
    /// The raster that shall be made of the newest ρ; cheap when unchanged. Columns 0: none.
    void submitRaster(const Box2 &box, int columns, int rows);
    /// Never null.
    std::shared_ptr<const DocumentPreview> latest() const;
    std::shared_ptr<const SpacingRaster> raster() const;
    /// False once everything submitted has been worked out.
    bool busy() const;

  private:
    struct RasterRequest {
        Box2 box;
        int columns = 0, rows = 0;
        std::uint64_t number = 0;
    };
    void work(const std::stop_token &stop);
    std::shared_ptr<const DocumentPreview> examine(const Document &document, std::uint64_t revision,
                                                   const std::stop_token &stop) const;

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::shared_ptr<const Document> wanted_;
    std::uint64_t wantedRevision_ = 0;
    RasterRequest wantedRaster_;
    std::uint64_t doneRevision_ = 0, rasterNumber_ = 0, rasterRevision_ = 0;
    std::shared_ptr<const DocumentPreview> preview_;
    std::shared_ptr<const SpacingRaster> raster_;
    std::stop_source examining_;
    std::jthread thread_;
};

} // namespace forefront
