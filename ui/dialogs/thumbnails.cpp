#include "ui/dialogs/thumbnails.hpp"

#include "core/drawing/document/document.hpp"
#include "core/drawing/domain/document_domain.hpp"
#include "core/drawing_files/documents.hpp"
#include "core/engine/improve/improve.hpp"
#include "core/engine/mesher/mesher.hpp"
#include "core/engine/pipeline/pipeline.hpp"
#include "core/engine/spacing/spacing_field.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace forefront {
namespace {

/// Approximate number of elements of a thumbnail; more would blur into grey at this size.
constexpr double kElements = 700.0;

void addEdges(const TriMesh &mesh, Thumbnail &thumbnail) {
    const auto number = [](NodeId id) { return static_cast<std::uint32_t>(index(id)); };
    for (const Element &e : mesh.elements) {
        thumbnail.elements.push_back({number(e[0]), number(e[1]), number(e[2])});
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = number(e[k]), b = number(e[(k + 1) % 3]);
            thumbnail.edges.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    std::sort(thumbnail.edges.begin(), thumbnail.edges.end());
    thumbnail.edges.erase(std::unique(thumbnail.edges.begin(), thumbnail.edges.end()), thumbnail.edges.end());
    for (const TaggedEdge &edge : mesh.edges) {
        thumbnail.boundary.push_back({number(edge.a), number(edge.b)});
    }
}

void addFineness(const TriMesh &mesh, const SpacingField &spacing, Thumbnail &thumbnail) {
    const double lowest = std::log(spacing.minimum()), span = std::log(spacing.maximum()) - lowest;
    for (const Element &e : mesh.elements) {
        const Vec2 middle = (1.0 / 3.0) * (mesh.nodes[index(e[0])] + mesh.nodes[index(e[1])] + mesh.nodes[index(e[2])]);
        const double t = span > 0.02 ? (std::log(spacing.at(middle)) - lowest) / span : 0.5;
        thumbnail.fineness.push_back(static_cast<float>(std::clamp(t, 0.0, 1.0)));
    }
}

std::shared_ptr<const Thumbnail> makeThumbnail(const std::filesystem::path &project, const std::stop_token &stop) {
    auto thumbnail = std::make_shared<Thumbnail>();
    ImportOptions options;
    options.regularFile = true;
    const Result<Document> document = readDocument(project, options);
    if (!document) {
        return thumbnail;
    }
    const MeshingJob job = jobOf(*document);
    Progress progress;
    progress.stop = stop;
    const Result<PreparedJob> prepared = prepare(job, progress, kElements);
    if (!prepared) {
        return thumbnail;
    }
    const std::unique_ptr<Mesher> mesher = Mesher::create(prepared->boundary, prepared->spacing, job.options);
    if (hasErrors(advanceToEnd(*mesher, *prepared, job.options, "", progress))) {
        return thumbnail;
    }
    TriMesh mesh = std::move(*mesher).takeMesh();
    improve(mesh, {job.options.improve, 1, prepared->spacing.get()}, progress);
    thumbnail->box = mesh.bounds();
    addEdges(mesh, *thumbnail);
    addFineness(mesh, *prepared->spacing, *thumbnail);
    thumbnail->nodes = std::move(mesh.nodes);
    return thumbnail;
}

} // namespace

Thumbnails::Thumbnails(std::vector<std::filesystem::path> projects, std::function<void()> wake)
    : Thumbnails(std::move(projects), std::move(wake), makeThumbnail) {}

Thumbnails::Thumbnails(std::vector<std::filesystem::path> projects, std::function<void()> wake, Make make)
    : projects_(std::move(projects)), wake_(std::move(wake)), make_(std::move(make)), made_(projects_.size()),
      thread_([this](const std::stop_token &stop) { work(stop); }) {}

Thumbnails::~Thumbnails() = default;

std::shared_ptr<const Thumbnail> Thumbnails::at(std::size_t project) const {
    const std::lock_guard lock(mutex_);
    return made_[project];
}

bool Thumbnails::done() const {
    const std::lock_guard lock(mutex_);
    return std::all_of(made_.begin(), made_.end(), [](const auto &made) { return made != nullptr; });
}

void Thumbnails::work(const std::stop_token &stop) {
    for (std::size_t i = 0; i < projects_.size() && !stop.stop_requested(); ++i) {
        std::shared_ptr<const Thumbnail> thumbnail;
        try {
            thumbnail = make_(projects_[i], stop);
        } catch (const std::bad_alloc &) {
            thumbnail = std::make_shared<const Thumbnail>(); // no picture, as for a project with faults
        }
        {
            const std::lock_guard lock(mutex_);
            made_[i] = std::move(thumbnail);
        }
        wake_();
    }
}

} // namespace forefront
