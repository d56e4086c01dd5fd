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

DocumentExaminer::DocumentExaminer(BackgroundList &list)
    : worker_(list, answer, {}, LeavableThread::kForever, NewsPace::WithPreview), layers_(list) {}

void DocumentExaminer::submit(std::shared_ptr<SharedDomain> drawn, std::uint64_t revision,
                              std::shared_ptr<SharedSpacing> spacing) {
    if (revision == wanted_.revision) {
        return;
    }
    wanted_.drawn = std::move(drawn);
    wanted_.spacing = std::move(spacing);
    wanted_.revision = revision;
    worker_.submit(wanted_);
}

void DocumentExaminer::abandon() {
    worker_.cancel();
    layers_.abandon();
    wanted_.revision = preview()->revision;
    if (worker_.now().rasterNumber != wanted_.raster.number || raster()->revision != wanted_.revision) {
        worker_.submit(wanted_); // of the preview that is shown
    }
}

void DocumentExaminer::submitRaster(const Box2 &box, int columns, int rows) {
    const RasterRequest &last = wanted_.raster;
    if (box == last.box && columns == last.columns && rows == last.rows) {
        return;
    }
    wanted_.raster = {box, columns, rows, last.number + 1};
    worker_.submit(wanted_);
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

std::shared_ptr<const DocumentPreview> DocumentExaminer::examine(const Request &request, const std::stop_token &stop) {
    SharedDomain &drawn = *request.drawn;
    auto preview = std::make_shared<DocumentPreview>();
    preview->revision = request.revision;
    const std::shared_ptr<const MeshingJob> job = drawn.job();
    const std::shared_ptr<const Domain> domain = drawn.get();
    preview->domain = domain;
    if (!drawn.document()->constraints.empty()) {
        preview->sketch = std::make_shared<const SketchState>(sketchState(*drawn.document()));
    }
    if (domain->nodes.empty()) {
        return preview;
    }
    DomainFaces faces;
    preview->faults = validate(*domain, kMaxListedFaults, &faces);
    const bool valid = preview->faults.empty();
    if (domain->segments.size() <= kMaxMapped || !domain->regionMarkers.empty()) {
        preview->faces = valid ? std::make_shared<const FaceMap>(domain, faces) : repairedFaceMap(*domain, stop);
    }
    for (std::size_t k = 0; valid && k < job->mapped.size(); ++k) {
        preview->mapped[job->mapped[k].region] = mappedOutlines(job->mapped[k], *domain, faces);
    }
    Progress progress;
    progress.stop = stop;
    const GivenSegments segments = job->options.keepBoundary ? GivenSegments::Kept : GivenSegments::Divided;
    Result<std::shared_ptr<const SpacingField>> field = request.spacing->get(job->spacing, *domain, progress, segments);
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

DocumentExaminer::Answer DocumentExaminer::answer(const LatestTurn<Request, Answer> &turn) {
    const Request &request = turn.request;
    const auto sample = [&raster = request.raster](Answer &now) {
        try {
            now.raster = sampleRaster(now.preview->spacing.get(), raster.box, raster.columns, raster.rows,
                                      now.preview->revision);
        } catch (const std::bad_alloc &) { // without a picture of the spacing, all else goes on
            now.raster = std::make_shared<SpacingRaster>();
        }
        now.rasterNumber = raster.number;
    };
    Answer now = turn.earlier;
    const bool newer = request.drawn && request.revision != now.preview->revision;
    // Raster first, so that it follows the view even while edits keep coming.
    if (!newer || now.rasterNumber != request.raster.number) {
        sample(now);
        if (newer) {
            turn.publish(now);
        }
    }
    if (newer) {
        try {
            now.preview = examine(request, turn.stop);
        } catch (const std::bad_alloc &) {
            now.preview = withoutMemory(request.revision);
        }
        turn.publish(now);
        sample(now);
    }
    return now;
}

} // namespace forefront
