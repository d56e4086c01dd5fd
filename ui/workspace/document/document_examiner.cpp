#include "ui/workspace/document/document_examiner.hpp"

#include "core/drawing/document/document.hpp"
#include "core/engine/boundary/discretise.hpp"
#include "core/engine/boundary/estimate.hpp"
#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/validate.hpp"

#include <algorithm>
#include <new>
#include <vector>

namespace forefront {

DocumentExaminer::DocumentExaminer(std::function<void()> wake)
    : wake_(std::move(wake)), preview_(std::make_shared<DocumentPreview>()), raster_(std::make_shared<SpacingRaster>()),
      thread_([this](const std::stop_token &stop) { work(stop); }) {}

DocumentExaminer::~DocumentExaminer() {
    thread_.request_stop();
    const std::lock_guard lock(mutex_);
    examining_.request_stop();
    changed_.notify_all();
}

void DocumentExaminer::submit(std::shared_ptr<SharedDomain> drawn, std::uint64_t revision,
                              std::shared_ptr<SharedSpacing> spacing) {
    const std::lock_guard lock(mutex_);
    if (revision == wantedRevision_) {
        return;
    }
    wanted_ = std::move(drawn);
    wantedSpacing_ = std::move(spacing);
    wantedRevision_ = revision;
    changed_.notify_all();
}

void DocumentExaminer::abandon() {
    const std::lock_guard lock(mutex_);
    wantedRevision_ = doneRevision_;
    examining_.request_stop();
}

void DocumentExaminer::submitRaster(const Box2 &box, int columns, int rows) {
    const std::lock_guard lock(mutex_);
    if (box == wantedRaster_.box && columns == wantedRaster_.columns && rows == wantedRaster_.rows) {
        return;
    }
    wantedRaster_ = {box, columns, rows, wantedRaster_.number + 1};
    changed_.notify_all();
}

std::shared_ptr<const DocumentPreview> DocumentExaminer::latest() const {
    const std::lock_guard lock(mutex_);
    return preview_;
}

std::shared_ptr<const SpacingRaster> DocumentExaminer::raster() const {
    const std::lock_guard lock(mutex_);
    return raster_;
}

bool DocumentExaminer::busy() const {
    const std::lock_guard lock(mutex_);
    return doneRevision_ != wantedRevision_ || rasterNumber_ != wantedRaster_.number ||
           rasterRevision_ != doneRevision_;
}

namespace {

/// Drawings with more segments and without regions get no map of their faces, which would delay the preview.
constexpr std::size_t kMaxMapped = 50000;

/// Returns the largest spacing at places in the faces and on the outlines of a domain; 0 if there are none. The bound
/// of the field is that of a box, corners outside the domain included.
double largestSpacingIn(const Domain &domain, const FaceMap &faces, const SpacingField &field) {
    constexpr int kSteps = 64; // along each side of the box
    constexpr std::size_t kMaxNodes = 4096;
    std::vector<Vec2> places;
    const Box2 box = domain.bounds();
    for (int row = 0; row < kSteps; ++row) {
        for (int column = 0; column < kSteps; ++column) {
            const Vec2 p = box.min + Vec2{(column + 0.5) / kSteps * box.size().x, (row + 0.5) / kSteps * box.size().y};
            if (faces.faceAt(p) != kNoIndex) {
                places.push_back(p);
            }
        }
    }
    for (std::size_t k = 0; k < std::min(domain.segments.size(), kMaxNodes); ++k) {
        places.push_back(domain.nodes[domain.segments[k].a]);
    }
    std::vector<double> rho(places.size());
    field.atMany(places, rho);
    return rho.empty() ? 0.0 : *std::max_element(rho.begin(), rho.end());
}

} // namespace

std::shared_ptr<const DocumentPreview> DocumentExaminer::examine(SharedDomain &drawn, std::uint64_t revision,
                                                                 SharedSpacing &spacing, const std::stop_token &stop) {
    auto preview = std::make_shared<DocumentPreview>();
    preview->revision = revision;
    const std::shared_ptr<const MeshingJob> job = drawn.job();
    const std::shared_ptr<const Domain> domain = drawn.get();
    preview->domain = domain;
    if (domain->nodes.empty()) {
        return preview;
    }
    DomainFaces faces;
    preview->faults = validate(*domain, kMaxListedFaults, &faces);
    const bool valid = preview->faults.empty();
    if (domain->segments.size() <= kMaxMapped || !domain->regionMarkers.empty()) {
        preview->faces = valid ? std::make_shared<const FaceMap>(domain, faces) : repairedFaceMap(*domain, stop);
    }
    Progress progress;
    progress.stop = stop;
    const GivenSegments segments = job->options.keepBoundary ? GivenSegments::Kept : GivenSegments::Divided;
    Result<std::shared_ptr<const SpacingField>> field = spacing.get(job->spacing, *domain, progress, segments);
    if (!field) {
        preview->faults.insert(preview->faults.end(), field.faults().begin(), field.faults().end());
        return preview;
    }
    preview->spacing = *field;
    if (preview->faces && !preview->faces->faces().empty()) {
        preview->largestSpacing = largestSpacingIn(*domain, *preview->faces, **field);
    }
    if (!hasErrors(preview->faults)) {
        // The estimate needs only the faces, so the segments are not divided.
        if (const Result<DiscreteDomain> outline =
                discretise(*domain, **field, true, progress, valid ? &faces : nullptr)) {
            preview->estimatedElements = estimateElements(*outline, **field);
        }
    }
    return preview;
}

namespace {

std::shared_ptr<const SpacingRaster> sampleRaster(const SpacingField *field, const Box2 &box, int columns, int rows,
                                                  std::uint64_t revision) {
    auto raster = std::make_shared<SpacingRaster>();
    raster->revision = revision;
    raster->box = box;
    if (field == nullptr || columns <= 0 || rows <= 0 || box.empty()) {
        return raster;
    }
    raster->columns = columns;
    raster->rows = rows;
    raster->rho.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    std::vector<Vec2> points(static_cast<std::size_t>(columns));
    std::vector<double> rho(points.size());
    const Vec2 cell{box.size().x / columns, box.size().y / rows};
    auto out = raster->rho.begin();
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            points[static_cast<std::size_t>(column)] = {box.min.x + (column + 0.5) * cell.x,
                                                        box.min.y + (row + 0.5) * cell.y};
        }
        field->atMany(points, rho);
        out = std::transform(rho.begin(), rho.end(), out, [](double r) { return static_cast<float>(r); });
    }
    return raster;
}

std::shared_ptr<const DocumentPreview> withoutMemory(std::uint64_t revision) {
    auto preview = std::make_shared<DocumentPreview>();
    preview->revision = revision;
    preview->domain = std::make_shared<Domain>();
    preview->faults = error("out-of-memory", "there is not enough memory to examine the drawing",
                            "close other programs, or simplify the drawing");
    return preview;
}

} // namespace

void DocumentExaminer::work(const std::stop_token &stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        // Raster first, so that it follows the newest finished field even while edits keep coming.
        if (rasterNumber_ != wantedRaster_.number || rasterRevision_ != doneRevision_) {
            const RasterRequest request = wantedRaster_;
            const std::shared_ptr<const SpacingField> field = preview_->spacing;
            const std::uint64_t revision = doneRevision_;
            lock.unlock();
            auto raster = sampleRaster(field.get(), request.box, request.columns, request.rows, revision);
            lock.lock();
            raster_ = std::move(raster);
            rasterNumber_ = request.number;
            rasterRevision_ = revision;
        } else if (doneRevision_ != wantedRevision_) {
            const std::shared_ptr<SharedDomain> drawn = wanted_;
            const std::shared_ptr<SharedSpacing> spacing = wantedSpacing_;
            const std::uint64_t revision = wantedRevision_;
            examining_ = std::stop_source();
            const std::stop_token superseded = examining_.get_token();
            lock.unlock();
            std::shared_ptr<const DocumentPreview> preview;
            try {
                preview = examine(*drawn, revision, *spacing, superseded);
            } catch (const std::bad_alloc &) {
                preview = withoutMemory(revision);
            }
            lock.lock();
            if (!superseded.stop_requested()) {
                preview_ = std::move(preview);
                doneRevision_ = revision;
            }
        } else {
            changed_.wait(lock, stop, [this] {
                return doneRevision_ != wantedRevision_ || rasterNumber_ != wantedRaster_.number ||
                       rasterRevision_ != doneRevision_;
            });
            continue;
        }
        lock.unlock();
        if (wake_) {
            wake_();
        }
        lock.lock();
    }
}

} // namespace forefront
