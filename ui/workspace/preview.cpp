#include "ui/workspace/preview.hpp"

#include "core/domain/validate.hpp"
#include "core/edit/document.hpp"

#include <algorithm>
#include <cmath>

namespace forefront {

namespace {

/// Collects the x coordinates, sorted, at which a horizontal line crosses boundary segments.
void crossings(const Domain &domain, double y, std::vector<double> &xs) {
    xs.clear();
    for (const DomainSegment &segment : domain.segments) {
        if (segment.role != SegmentRole::Boundary || segment.a >= domain.nodes.size() ||
            segment.b >= domain.nodes.size()) {
            continue;
        }
        const Vec2 a = domain.nodes[segment.a], b = domain.nodes[segment.b];
        if ((a.y <= y) != (b.y <= y)) {
            xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    }
    std::sort(xs.begin(), xs.end());
}

/// Returns ∫ 4/(√3 ρ²) dA over the domain: the number of equilateral triangles with side ρ that fill it.
double estimateElements(const Domain &domain, const SpacingField &spacing) {
    constexpr int kRows = 160, kColumns = 160;
    const Box2 box = domain.bounds();
    if (box.empty()) {
        return 0.0;
    }
    const Vec2 cell{box.size().x / kColumns, box.size().y / kRows};
    std::vector<double> xs;
    std::vector<Vec2> points;
    for (int row = 0; row < kRows; ++row) {
        const double y = box.min.y + (row + 0.5) * cell.y;
        crossings(domain, y, xs);
        for (int column = 0; column < kColumns; ++column) {
            const double x = box.min.x + (column + 0.5) * cell.x;
            const auto before = std::lower_bound(xs.begin(), xs.end(), x) - xs.begin();
            if (before % 2 == 1) {
                points.push_back({x, y});
            }
        }
    }
    std::vector<double> rho(points.size());
    spacing.atMany(points, rho);
    double sum = 0.0;
    for (const double r : rho) {
        sum += 4.0 / (std::sqrt(3.0) * r * r);
    }
    return sum * cell.x * cell.y;
}

} // namespace

Preview::Preview(std::function<void()> wake)
    : wake_(std::move(wake)), preview_(std::make_shared<DocumentPreview>()), raster_(std::make_shared<SpacingRaster>()),
      thread_([this](const std::stop_token &stop) { work(stop); }) {}

Preview::~Preview() {
    thread_.request_stop();
    const std::lock_guard lock(mutex_);
    examining_.request_stop();
    changed_.notify_all();
}

void Preview::submit(std::shared_ptr<const Document> document, std::uint64_t revision) {
    const std::lock_guard lock(mutex_);
    if (revision == wantedRevision_) {
        return;
    }
    wanted_ = std::move(document);
    wantedRevision_ = revision;
    changed_.notify_all();
}

void Preview::abandon() {
    const std::lock_guard lock(mutex_);
    wantedRevision_ = doneRevision_;
    examining_.request_stop();
}

void Preview::submitRaster(const Box2 &box, int columns, int rows) {
    const std::lock_guard lock(mutex_);
    if (box == wantedRaster_.box && columns == wantedRaster_.columns && rows == wantedRaster_.rows) {
        return;
    }
    wantedRaster_ = {box, columns, rows, wantedRaster_.number + 1};
    changed_.notify_all();
}

std::shared_ptr<const DocumentPreview> Preview::latest() const {
    const std::lock_guard lock(mutex_);
    return preview_;
}

std::shared_ptr<const SpacingRaster> Preview::raster() const {
    const std::lock_guard lock(mutex_);
    return raster_;
}

bool Preview::busy() const {
    const std::lock_guard lock(mutex_);
    return doneRevision_ != wantedRevision_ || rasterNumber_ != wantedRaster_.number ||
           rasterRevision_ != doneRevision_;
}

std::shared_ptr<const DocumentPreview> Preview::examine(const Document &document, std::uint64_t revision,
                                                        const std::stop_token &stop) const {
    auto preview = std::make_shared<DocumentPreview>();
    preview->revision = revision;
    auto domain = std::make_shared<Domain>(toDomain(document));
    preview->domain = domain;
    if (domain->nodes.empty()) {
        return preview;
    }
    preview->faults = validate(*domain);
    Progress progress;
    progress.stop = stop;
    Result<std::shared_ptr<const SpacingField>> field = SpacingField::build(document.spacing, *domain, progress);
    if (!field) {
        preview->faults.insert(preview->faults.end(), field.faults().begin(), field.faults().end());
        return preview;
    }
    preview->spacing = *field;
    if (!hasErrors(preview->faults)) {
        preview->estimatedElements = estimateElements(*domain, **field);
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

} // namespace

void Preview::work(const std::stop_token &stop) {
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
            const std::shared_ptr<const Document> document = wanted_;
            const std::uint64_t revision = wantedRevision_;
            examining_ = std::stop_source();
            const std::stop_token superseded = examining_.get_token();
            lock.unlock();
            auto preview = examine(*document, revision, superseded);
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
